/// Values of scene files that a picture may give.
#pragma once
#include "scene/textures/texture.h"

namespace brandung {

class Parameters;

/// A spectrum, and the picture that it is multiplied by.
struct TexturedSpectrum {
    Spectrum value;
    uint texture;  ///< number + 1, 0: none
};

/// A spectrum, or {"texture": FILE, "wrap": "repeat" or "clamp", "encoding": "auto", "srgb" or "linear", "scale": SPECTRUM}. Names of files are
/// relative to the scene's folder. Throws SceneError.
TexturedSpectrum read_textured(const Parameters &parameters, const std::string &name, Spectrum fallback, Scene &scene);

/// The same, no spectrum beyond 1; the scale of a picture, which may be dark, has no bound.
TexturedSpectrum read_textured_fraction(const Parameters &parameters, const std::string &name, Spectrum fallback, Scene &scene);

/// The value "background": a spectrum, or {"image": FILE, "encoding": ..., "rotate": DEGREES, "scale": SPECTRUM}, if there is one.
void read_background(const Parameters &root, Scene &scene);

}  // namespace brandung
