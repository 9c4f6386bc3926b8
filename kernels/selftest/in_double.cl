// From here on floats of the source are doubles: what results differ by from those in float is due to rounding alone. Only for one lane, and not for
// functions that are made of a float's bits. Records in memory have doubles in place of their floats.
#pragma OPENCL EXTENSION cl_khr_fp64 : enable

// Literals stay floats, exactly: the library's functions of several arguments must not have to choose between both types. Of a number's bits only
// the exponent is asked, for a power of two.
static inline double fma_of_doubles(double a, double b, double c) { return fma(a, b, c); }
static inline double copysign_of_doubles(double a, double b) { return copysign(a, b); }
static inline int bits_of_float(double x) { return as_int((float)x); }
static inline uint unsigned_bits_of_float(double x) { return as_uint((float)x); }
static inline double float_of_bits(uint bits) { return as_float(bits); }
#undef fma
#undef copysign
#undef as_int
#undef as_uint
#undef as_float
#define fma fma_of_doubles
#define copysign copysign_of_doubles
#define as_int bits_of_float
#define as_uint unsigned_bits_of_float
#define as_float float_of_bits
#define float double
