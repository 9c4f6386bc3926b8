/// One shape, read as the native format reads it.
#pragma once
#include <string>

#include "scene/error.h"
#include "scene/parameters.h"
#include "scene/scene.h"

namespace brandung {

/// A scene with what the JSON object describes, of material 7. Throws SceneError.
inline Scene read_shape(const std::string &json) {
    const Document document = parse_document("shape.json", json);
    const Parameters parameters(document, "");
    const std::string type = parameters.text("type");
    Scene scene;
    for (const ShapeReader &reader : shape_readers()) {
        if (reader.name == type) reader.read(parameters, 7, scene);
    }
    parameters.expect_all_known();
    return scene;
}

/// What is wrong with a shape; empty if nothing.
inline std::string error_of_shape(const std::string &json) {
    try {
        read_shape(json);
    } catch (const SceneError &error) {
        return error.what();
    }
    return "";
}

}  // namespace brandung
