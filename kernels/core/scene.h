/// The scene as the device sees it: a header of spans into one read-only arena.
#pragma once
#include "kernels/core/portable.h"

/// Records of one type in the arena: they begin at 64 * offset bytes.
typedef struct {
    uint offset, count;
} Span;

#define NO_MATERIAL 0xffffffffu
#define MAX_PRIMITIVE_KINDS 8u
#define BLOCK_SIZE 8u

/// What shading needs of one primitive, a cache line; the kind's own view of `words` is in its header.
typedef struct {
    uint kind, material;
    uint words[14];
} ShadingRecord;

#define MATERIAL_REFLECTS 1u
#define MATERIAL_TRANSMITS 2u
#define MATERIAL_SPAWNS_ALWAYS 4u  ///< its rays are traced at weight 0 too
#define MATERIAL_LIT 8u            ///< light from lights can be seen on it
#define MATERIAL_HIGHLIGHT 16u     ///< as a highlight too
#define MATERIAL_DARK_FRONT 32u    ///< its emission leaves only the side that the geometric normal leads away from,
#define MATERIAL_DARK_BACK 64u     ///< or only the other one
#define MATERIAL_SHINES 128u       ///< its emission is not black
#define MATERIAL_CHOOSES 256u      ///< at every hit another one counts in its place: kernels/bsdfs/choice.h
#define MATERIAL_DIFFUSE 512u      ///< it takes bundles of rays that go on as large as for diffuse reflection,
#define MATERIAL_GLOSSY 1024u      ///< for reflection of other kinds, unless that is one ray,
#define MATERIAL_PASSES 2048u      ///< or for transmission
#define MATERIAL_IDEAL 4096u       ///< it mirrors light, or lets it pass, in single directions
#define MATERIAL_FACETS 8192u      ///< its facets are of distribution 0; the next bit: of distribution 1 (kernels/bsdfs/microfacet.cl)
#define MATERIAL_LOSES 32768u      ///< they take light from each other as a table of losses says (kernels/bsdfs/losses.cl)

/// A surface's material; 128 bytes. `words` is the kind's own.
typedef struct {
    uint kind, flags;
    uint priority;                           ///< of the medium inside; where several overlap, the highest counts
    float eta;                               ///< index of refraction inside
    Spectrum emission;                       ///< radiance
    uint diffuse_texture, specular_texture;  ///< number + 1 of the pictures that these reflectances are multiplied by; 0: none
    uint words[23];
} Material;

/// A light, or a stratum of an emissive shape; 64 bytes. `words` is the kind's own.
typedef struct {
    uint kind;
    uint words[15];
} Light;

/// Primitives in one space, with an accelerator above them.
typedef struct {
    Span blocks[MAX_PRIMITIVE_KINDS];  ///< per kind in use: blocks of BLOCK_SIZE primitives
    Span nodes;                        ///< the accelerator's own
    float extent;                      ///< largest magnitude of a coordinate of the primitives' bounds
} Group;

typedef struct {
    Group world;
    Span groups;                     ///< Group per group that has instances
    Span instances;                  ///< Instance, the world's being the first; none in scenes without them
    Span motion_parts;               ///< MotionPart of instances that move
    Span shading;                    ///< ShadingRecord per primitive, in scene order; those of groups come last
    Span vertex_normals;             ///< VertexNormals of smooth triangles
    Span vertex_uvs, vertex_colors;  ///< VertexUvs, VertexColors of triangles that have some
    Span emissive_faces;             ///< EmissiveFace of meshes that shine
    Span materials, lights;
    Span light_choices;     ///< LightChoice by light, for paths
    float emission_chance;  ///< density of paths' points by area as power counts it on emissive shapes, over their mean radiance; 0: none are chosen
    Span textures;          ///< TextureRecord
    // If paths ask for light of the background: EnvironmentRow, and of each row where its cells begin, and those of them that are marks.
    Span environment_rows, environment_begins, environment_marks;
    uint environment_row_count, environment_columns;  ///< cells per column and row
    float environment_density;                        ///< mean density with which they ask for a direction [1/sr]
    Spectrum background, ambient;
    uint background_texture;  ///< number + 1 of the picture that the background is multiplied by; 0: none
    float background_turn;    ///< by which the picture is turned about the y axis [turns]
} SceneHeader;
