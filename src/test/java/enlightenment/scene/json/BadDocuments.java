package enlightenment.scene.json;

import java.util.List;

/** Edits of {@link Documents#EVERYTHING} that break it, each in one place. */
final class BadDocuments {
    /**
     * One edit.
     *
     * @param part what is replaced
     * @param replacement by what
     * @param pointer where the reader sees the problem
     * @param says what its message contains
     */
    record Edit(String part, String replacement, String pointer, String says) {
        String document() {
            return Documents.edited(part, replacement);
        }
    }

    private static Edit edit(String part, String replacement, String pointer, String says) {
        return new Edit(part, replacement, pointer, says);
    }

    /** What reader and schema both refuse. */
    static final List<Edit> FOR_THE_SCHEMA_TOO = List.of(
            // Unknown keys, in each part.
            edit("\"name\": \"everything\"", "\"nam\": \"x\"", "/nam", "did you mean \"name\"?"),
            edit(
                    "\"height\": 20",
                    "\"height\": 20, \"depth\": 3",
                    "/image/depth",
                    "an image has \"width\", \"height\""),
            edit("\"pupilRadius\"", "\"pupil\"", "/camera/pupil", "unknown key; a window camera has"),
            edit("\"ambient\"", "\"ambience\"", "/shading/ambience", "did you mean \"ambient\"?"),
            edit("\"filter\"", "\"filters\"", "/textures/ice/filters", "did you mean \"filter\"?"),
            edit(
                    "{ \"linear\": [0.25, 0.5, 1] }",
                    "{ \"linaer\": [0.25, 0.5, 1] }",
                    "/materials/ember/color",
                    "or {\"texture\": NAME}, not an object with \"linaer\"; did you mean \"linear\"?"),
            edit(
                    "{ \"linear\": [0.25, 0.5, 1] }",
                    "{}",
                    "/materials/ember/color",
                    "or {\"texture\": NAME}, not an empty object"),
            edit(
                    "\"color\": \"#ffffff\", \"radiance\": [200",
                    "\"color\": {\"lineal\": [1, 1, 1]}, \"radiance\": [200",
                    "/lights/0/color",
                    "of at least 0, not an object with \"lineal\"; did you mean \"linear\"?"),
            edit("\"#0000ff\"", "{}", "/textures/plain/color", "of at least 0, not an empty object"),
            edit("\"scale\": 8", "\"scale\": 8, \"size\": 3", "/textures/checks/size", "a checker texture has"),
            edit("\"transparency\"", "\"transparancy\"", "/materials/glass/transparancy", "\"transparency\"?"),
            edit(
                    "\"position\": [0, 5, 5]",
                    "\"position\": [0, 5, 5], \"radius\": 1",
                    "/lights/2/radius",
                    "a point light"),
            edit("\"rotation\": 200", "\"rotatoin\": 200", "/objects/0/rotatoin", "did you mean \"rotation\"?"),
            edit(
                    "{ \"texture\": \"checks\" }",
                    "{ \"texture\": \"checks\", \"x\": 1 }",
                    "/objects/3/material/color/x",
                    "unknown key"),
            edit("\"seed\"", "\"Seed\"", "/render/Seed", "did you mean \"seed\"?"),
            edit("\"frames\": 11", "\"frames\": 11, \"loop\": true", "/animation/loop", "an animation has"),
            edit("\"keys\": {", "\"colour\": 1, \"keys\": {", "/animation/tracks/0/colour", "a track has"),
            // Missing keys.
            edit("\"image\": { \"width\": 40, \"height\": 20 },", "", "/image", "missing; a scene needs it"),
            edit("\"width\": 40, ", "", "/image/width", "missing; an image needs it"),
            edit("\"eye\": [0, 1, -3], ", "", "/camera/eye", "missing; a window camera needs it"),
            edit("\"type\": \"window\", ", "", "/camera/type", "expected one of \"window\", \"perspective\""),
            edit(" \"file\": \"ice.png\",", "", "/textures/ice/file", "missing; a file texture needs it"),
            edit("\"color\": [0.1, 0.2, 0.3], ", "", "/materials/chrome/color", "missing; a mirror material"),
            edit("\"indexOfRefraction\": 1.5, ", "", "/materials/glass/indexOfRefraction", "missing"),
            edit(", \"color\": [1, 1, 1]", "", "/lights/2/color", "missing; a point light needs it"),
            edit("\"radius\": 1.5, ", "", "/objects/0/radius", "missing; a sphere needs it"),
            edit("\"normal\": [0, 2, 0], ", "", "/objects/2/normal", "missing; a disk needs it"),
            edit("\"framesPerSecond\": 25,", "", "/animation/framesPerSecond", "missing"),
            edit("\"target\": \"/objects/0/center/1\", ", "", "/animation/tracks/0/target", "missing"),
            // Wrong types.
            edit("\"name\": \"everything\"", "\"name\": 3", "/name", "must be a text, not the number 3"),
            edit(
                    "{ \"width\": 40, \"height\": 20 }",
                    "[40, 20]",
                    "/image",
                    "must be an image, an object { ... }, not an array"),
            edit("\"width\": 40", "\"width\": 40.5", "/image/width", "must be a whole number in 1..65536, not 40.5"),
            edit(
                    "\"radius\": 1.5",
                    "\"radius\": \"1.5\"",
                    "/objects/0/radius",
                    "must be a number, not the text \"1.5\""),
            edit("\"radius\": 1.5", "\"radius\": null", "/objects/0/radius", "must be a number, not null"),
            edit("\"radius\": 1.5", "\"radius\": true", "/objects/0/radius", "must be a number, not true"),
            edit("\"radius\": 1.5", "\"radius\": [1]", "/objects/0/radius", "not an array of 1 value"),
            edit("\"radius\": 1.5", "\"radius\": {}", "/objects/0/radius", "must be a number, not an object"),
            edit("\"radius\": 1.5", "\"radius\": \"NaN\"", "/objects/0/radius", "not the text \"NaN\""),
            edit("[-2, 1.10, 4]", "[-2, 4]", "/objects/0/center", "must be a position [x, y, z], not an array of 2"),
            edit("[-2, 1.10, 4]", "[\"-2\", 1.10, 4]", "/objects/0/center/0", "must be a number, not the text"),
            edit("[3, 0, 3]", "4", "/objects/5/center", "must be a position [x, y, z], not the number 4"),
            edit("[0, 2, 0]", "\"up\"", "/objects/2/normal", "must be a direction [x, y, z], not the text"),
            edit("[10, 20, 30]", "30", "/objects/5/rotation", "must be three angles [x, y, z] in degrees"),
            edit(
                    "[[0, 0, 9], [1, 0, 9], [0, 1, 9]]",
                    "[[0, 0, 9], [1, 0, 9]]",
                    "/objects/8/vertices",
                    "three vertices"),
            edit("\"#010203\" }]", "\"#010203\" }, \"ice\"]", "/objects/5/faces", "six materials"),
            edit(
                    "\"radius\": 0.3, \"capped\": false",
                    "\"radius\": 0.3, \"capped\": 0",
                    "/objects/3/capped",
                    "must be true or false, not the number 0"),
            edit("\"method\": \"cluster\"", "\"method\": 1", "/render/method", "must be one of"),
            edit("\"seed\": 99", "\"seed\": 0.5", "/render/seed", "must be a whole number"),
            edit(
                    "{ \"0\": 1, \"10\": 2 }",
                    "[1, 2]",
                    "/animation/tracks/0/keys",
                    "must be values by frames, an object"),
            edit("\"10\": 2 }", "\"10\": \"2\" }", "/animation/tracks/0/keys/10", "must be a number"),
            edit("\"10\": 2 }", "\"ten\": 2 }", "/animation/tracks/0/keys/ten", "must be the number of a frame"),
            // Unknown words.
            edit("\"type\": \"window\"", "\"type\": \"windows\"", "/camera/type", "did you mean \"window\"?"),
            edit("\"type\": \"torus\"", "\"type\": \"donut\"", "/objects/7/type", "expected one of \"sphere\""),
            edit("\"type\": \"mirror\"", "\"type\": \"miror\"", "/materials/chrome/type", "did you mean \"mirror\"?"),
            edit(
                    "\"type\": \"point\"",
                    "\"type\": \"laser\"",
                    "/lights/2/type",
                    "expected one of \"sphere\", \"rectangle\", \"point\""),
            edit("\"type\": \"checker\"", "\"type\": \"noise\"", "/textures/checks/type", "expected one of"),
            edit("\"nearest\"", "\"neares\"", "/textures/ice/filter", "did you mean \"nearest\"?"),
            edit("\"encoding\": \"linear\"", "\"encoding\": \"gamma\"", "/textures/ice/encoding", "expected one of"),
            edit("\"method\": \"cluster\"", "\"method\": \"path\"", "/render/method", "expected one of \"raytrace\""),
            edit("\"model\": \"classic\"", "\"model\": \"classical\"", "/shading/model", "did you mean \"classic\"?"),
            // What is only classic.
            edit(
                    "\"model\": \"classic\", \"ambient\": 0.25, \"shadow\": 0.75",
                    "\"model\": \"physical\", \"ambient\": 0.25",
                    "/shading/ambient",
                    "all light comes from the lights"),
            edit(
                    "\"model\": \"classic\", \"ambient\": 0.25, \"shadow\": 0.75",
                    "\"model\": \"physical\", \"shadow\": 0.75",
                    "/shading/shadow",
                    "nothing of a hidden light arrives"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\", \"background\": {\"linear\": [0, -1, 2e9]}",
                    "/shading/background/linear/1",
                    "at least 0"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\", \"background\": {}",
                    "/shading/background",
                    "a picture, {\"texture\": \"...\"}, or a sky"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\", \"background\": {\"linear\": [0, 1]}",
                    "/shading/background/linear",
                    "three numbers"),
            edit("\"shadowSamples\": 7", "\"proposal\": \"gauss\"", "/render/proposal", "expected one of"),
            edit("\"maxBounces\": 7", "\"maxBounces\": -1", "/shading/maxBounces", "whole number"),
            // Meshes, groups and transforms.
            edit("\"type\": \"triangle\"", "\"type\": \"triangel\"", "/objects/8/type", "did you mean \"triangle\"?"),
            edit(
                    " \"file\": \"gem.obj\", \"part\": \"upper\", \"normals\"",
                    " \"normals\"",
                    "/meshes/gem/file",
                    "missing; a mesh needs it"),
            edit("\"crease\": 40", "\"crease\": 181", "/meshes/gem/crease", "0.0..180.0, not 181.0"),
            edit(
                    "\"normals\": \"smooth\", \"crease\": 40",
                    "\"normals\": \"flat\", \"crease\": 40",
                    "/meshes/gem/crease",
                    "\"smooth\""),
            edit("\"normals\": \"smooth\", \"crease\": 40", "\"crease\": 40", "/meshes/gem/crease", "\"smooth\""),
            edit(
                    "\"normals\": \"smooth\", \"crease\": 40",
                    "\"normals\": \"round\"",
                    "/meshes/gem/normals",
                    "expected one of \"file\""),
            edit(
                    "\"type\": \"mesh\", \"mesh\": \"gem\", \"transform\": [{ \"scale\": 0.5 }",
                    "\"type\": \"mesh\", \"transform\": [{ \"scale\": 0.5 }",
                    "/objects/9/mesh",
                    "missing; a mesh needs the name"),
            edit(
                    "\"type\": \"mesh\", \"mesh\": \"gem\", \"transform\": [{ \"scale\": 0.5 }",
                    "\"type\": \"mesh\", \"mesh\": \"gem\", \"file\": \"gem.obj\", \"transform\": [{ \"scale\": 0.5 }",
                    "/objects/9/file",
                    "not both"),
            edit(
                    "\"type\": \"mesh\", \"mesh\": \"gem\", \"transform\": [{ \"scale\": 0.5 }",
                    "\"type\": \"mesh\", \"mesh\": \"gem\", \"normals\": \"flat\", \"transform\": [{ \"scale\": 0.5 }",
                    "/objects/9/normals",
                    "stands where the mesh has its name"),
            edit(
                    "\"normals\": \"smooth\", \"crease\": 30",
                    "\"normals\": \"file\", \"crease\": 30",
                    "/objects/10/crease",
                    "\"smooth\""),
            edit("\"scale\": 0.5", "\"scale\": 0", "/objects/9/transform/0/scale", "must be finite and not 0"),
            edit(
                    "\"scale\": [1, 2, 3]",
                    "\"scale\": [1, 0, 3]",
                    "/objects/10/transform/0/scale",
                    "must be finite and not 0"),
            edit(
                    "\"scale\": [1, 2, 3]",
                    "\"scale\": [1, 2]",
                    "/objects/10/transform/0/scale",
                    "a factor, or three factors"),
            edit("\"scale\": 0.5", "\"size\": 0.5", "/objects/9/transform/0", "must be a step: {\"scale\": ...}"),
            edit("{ \"scale\": 0.5 }", "{}", "/objects/9/transform/0", "not an empty object"),
            edit("{ \"scale\": 0.5 }", "0.5", "/objects/9/transform/0", "must be a step"),
            edit(
                    "{ \"scale\": 0.5 }",
                    "{ \"scale\": 0.5, \"translate\": [0, 0, 1] }",
                    "/objects/9/transform/0/translate",
                    "unknown key"),
            edit("\"rotate\": [0, 45, 0]", "\"rotate\": 45", "/objects/9/transform/1/rotate", "three angles"),
            edit(
                    "\"axis\": [0, 1, 1], \"angle\": 30",
                    "\"axis\": [0, 1, 1]",
                    "/objects/10/transform/1/angle",
                    "missing"),
            edit(
                    "\"matrix\": [1, 0, 0, 5.5, 0, 0, -1, 0.1, 0, 1, 0, 7]",
                    "\"matrix\": [1, 0, 0, 0, 1, 0, 0, 0, 1]",
                    "/objects/10/transform/2/matrix",
                    "an array of 12 numbers"),
            edit(
                    "\"transform\": [{ \"translate\": [4, 0.1, 9] }]",
                    "\"transform\": { \"translate\": [4, 0.1, 9] }",
                    "/objects/11/transform",
                    "an array of steps"),
            edit(
                    "\"group\": \"pair\", \"transform\"",
                    "\"transform\"",
                    "/objects/11/group",
                    "missing; a group needs it"),
            edit(
                    "\"group\": \"pair\", \"transform\"",
                    "\"group\": \"pair\", \"material\": \"ice\", \"transform\"",
                    "/objects/11/material",
                    "unknown key; a group has"),
            edit("\"radius\": 0.5,", "\"radius\": -0.5,", "/groups/pair/0/radius", "greater than 0"),
            // Matter and surroundings, for physical shading.
            edit(
                    "\"anisotropy\": 0.375",
                    "\"anisotropy\": 1",
                    "/materials/wax/anisotropy",
                    "between -1 and 1, both excluded"),
            edit(
                    "\"anisotropy\": 0.375",
                    "\"anisotropy\": 0.375, \"scatteringCoefficient\": 3",
                    "/materials/wax/scatteringCoefficient",
                    "stands beside \"color\" and \"meanFreePath\""),
            edit(
                    "\"color\": \"#f0e0c0\", \"meanFreePath\": [0.3, 0.2, 0.1]",
                    "\"color\": \"#f0e0c0\"",
                    "/materials/wax/meanFreePath",
                    "missing; a medium has either \"color\" and \"meanFreePath\" or"),
            edit(
                    ", \"absorptionCoefficient\": 0.125",
                    "",
                    "/materials/milk/absorptionCoefficient",
                    "missing; a medium has either"),
            edit(
                    "\"absorptionCoefficient\": 0.125",
                    "\"absorptionCoefficient\": -0.125",
                    "/materials/milk/absorptionCoefficient",
                    "at least 0"),
            edit(
                    "\"absorptionCoefficient\": 0.125",
                    "\"absorptionCoefficient\": 0.125, \"absorption\": 0.125",
                    "/materials/milk/absorption",
                    "is called \"absorptionCoefficient\" here"),
            edit(
                    "\"roughness\": 0.125, \"priority\": 3",
                    "\"roughness\": 1.5, \"priority\": 3",
                    "/materials/wax/roughness",
                    "0.0..1.0"),
            edit(
                    "\"roughness\": 0.125, \"priority\": 3",
                    "\"radiance\": 0.125, \"priority\": 3",
                    "/materials/wax/radiance",
                    "media do not glow"),
            edit(
                    "\"indexOfRefraction\": 1.44",
                    "\"indexOfRefraction\": 0",
                    "/materials/wax/indexOfRefraction",
                    "greater than 0"),
            edit(
                    "\"absorption\": [320, 450]",
                    "\"absorption\": [290, 450]",
                    "/materials/marker/absorption",
                    "in 300..780 nm, not [290.0, 450.0]"),
            edit(
                    "\"emission\": [500, 600.5]",
                    "\"emission\": [500, 600, 700]",
                    "/materials/marker/emission",
                    "two wavelengths [from, to] in nanometres"),
            edit("\"yield\": 0.875", "\"yield\": 1.25", "/materials/marker/yield", "0.0..1.0"),
            edit(
                    "\"yield\": 0.875",
                    "\"yield\": 0.875, \"receivesShadows\": false",
                    "/materials/marker/receivesShadows",
                    "belongs to classic shading"),
            edit("\"dispersion\": 36.5", "\"dispersion\": 0", "/materials/glass/dispersion", "greater than 0"),
            edit("\"dispersion\": 36.5", "\"ultraviolet\": 1", "/materials/glass/ultraviolet", "glass does not glow"),
            edit("\"ultraviolet\": 7", "\"ultraviolet\": -7", "/lights/0/ultraviolet", "at least 0"),
            edit(
                    "\"ultraviolet\": 2.5",
                    "\"ultraviolet\": [1, 2, 3]",
                    "/materials/ember/ultraviolet",
                    "must be a number"),
            edit(
                    "\"maxBounces\": 7",
                    "\"medium\": { \"color\": \"#fff\", \"meanFreePath\": 3 }",
                    "/shading/medium",
                    "belongs to physical shading"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\", \"background\": {\"texture\": 3}",
                    "/shading/background/texture",
                    "the name of a texture"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\", \"background\": {\"texture\": \"ice\", \"radiance\": -3}",
                    "/shading/background/radiance",
                    "at least 0"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\", \"background\": {\"texture\": \"ice\", \"exposure\": 3}",
                    "/shading/background/exposure",
                    "unknown key"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\", \"background\": {\"type\": \"sky\"}",
                    "/shading/background/elevation",
                    "missing; a sky background needs it"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\", \"background\": {\"type\": \"sky\", \"elevation\": 91}",
                    "/shading/background/elevation",
                    "0.0..90.0"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\", \"background\": {\"type\": \"sky\", \"elevation\": 9, \"turbidity\": 11}",
                    "/shading/background/turbidity",
                    "2.0..10.0"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\", \"medium\": {}",
                    "/shading/medium/color",
                    "missing; a medium has either"),
            // Light, for physical shading.
            edit(
                    "\"radius\": 0.15,",
                    "\"radius\": 0.15, \"power\": 3,",
                    "/lights/0/power",
                    "stands beside \"radiance\"; a light has one of the two"),
            edit("\"intensity\": 3", "\"intensity\": 3, \"power\": 3", "/lights/2/power", "beside \"intensity\""),
            edit("\"intensity\": 3", "\"radiance\": 3", "/lights/2/radiance", "a point light has \"intensity\" or"),
            edit(
                    "\"power\": 40",
                    "\"intensity\": 40",
                    "/lights/1/intensity",
                    "belongs to point lights; a rectangle light has \"radiance\" or \"power\""),
            edit("\"power\": 40", "\"power\": -40", "/lights/1/power", "at least 0, not -40.0"),
            edit("\"power\": 40", "\"power\": \"40\"", "/lights/1/power", "must be a number, or [r, g, b]"),
            edit("[200, 150, 100]", "[200, 150]", "/lights/0/radiance", "not an array of 2 values"),
            edit("[200, 150, 100]", "[200, -150, 100]", "/lights/0/radiance/1", "at least 0, not -150.0"),
            edit("\"twoSided\": false", "\"twoSided\": 1", "/lights/1/twoSided", "true or false"),
            edit(
                    "\"position\": [0, 5, 5],",
                    "\"position\": [0, 5, 5], \"twoSided\": true,",
                    "/lights/2/twoSided",
                    "unknown"),
            // Materials, for physical shading.
            edit("\"roughness\": 0.375, ", "", "/materials/copper/roughness", "missing; a glossy material needs it"),
            edit("\"roughness\": 0.375", "\"roughness\": 1.5", "/materials/copper/roughness", "0.0..1.0, not 1.5"),
            edit("\"roughness\": 0.625", "\"roughness\": -1", "/materials/ember/roughness", "0.0..1.0, not -1.0"),
            edit(
                    "\"channel\": \"red\", \"factor\": 0.25",
                    "\"channel\": \"red\", \"factor\": 2",
                    "/materials/glass/roughness/factor",
                    "0.0..1.0, not 2.0"),
            edit(
                    "\"clearcoatRoughness\": {\"texture\": \"ice\", \"channel\": \"green\", \"factor\": 0.125}",
                    "\"clearcoatRoughness\": 2",
                    "/materials/enamel/clearcoatRoughness",
                    "0.0..1.0, not 2.0"),
            edit("\"sheen\": 0.4375", "\"sheen\": 2", "/materials/enamel/sheen", "0.0..1.0, not 2.0"),
            edit("\"sheenTint\": 0.3125", "\"sheenTint\": -1", "/materials/enamel/sheenTint", "0.0..1.0, not -1.0"),
            edit("[0.5, 0, 2]", "[0.5, 0, -2]", "/materials/glass/absorption/2", "at least 0, not -2.0"),
            edit(
                    "\"absorption\": [0.5, 0, 2]",
                    "\"radiance\": [0.5, 0, 2]",
                    "/materials/glass/radiance",
                    "belongs to opaque materials: glass does not glow"),
            edit(
                    "\"radiance\": 1.5",
                    "\"receivesShadows\": true",
                    "/materials/copper/receivesShadows",
                    "classic shading"),
            edit("\"k\": [3.91, 2.45, 2.14],", "", "/materials/copper/k", "\"eta\" and \"k\" belong together"),
            edit("\"eta\": [0.2, 0.92, 1.1], ", "", "/materials/copper/eta", "\"eta\" and \"k\" belong together"),
            edit(
                    "\"color\": \"#ffeeff\", \"roughness\": 0.375, \"eta\": [0.2, 0.92, 1.1], \"k\": [3.91, 2.45, 2.14],",
                    "\"roughness\": 0.375,",
                    "/materials/copper/color",
                    "missing; a glossy material needs it, or a \"metal\""),
            edit(
                    "\"roughness\": 0.375,",
                    "\"roughness\": 0.375, \"metal\": \"gold\",",
                    "/materials/copper/metal",
                    "must stand without \"eta\" and \"k\""),
            edit(
                    "\"eta\": [0.2, 0.92, 1.1], \"k\": [3.91, 2.45, 2.14],",
                    "\"metal\": \"Gold\",",
                    "/materials/copper/metal",
                    "did you mean \"gold\"?"),
            edit(
                    "\"metallic\": {\"texture\": \"ice\", \"channel\": \"blue\"}",
                    "\"metallic\": 2",
                    "/materials/enamel/metallic",
                    "0.0..1.0, not 2.0"),
            edit("\"channel\": \"blue\"", "\"channel\": \"b\"", "/materials/enamel/metallic/channel", "\"blue\""),
            edit("\"factor\": 0.75", "\"factor\": 7", "/materials/enamel/roughness/factor", "0.0..1.0, not 7.0"),
            edit("\"clearcoat\": 0.25", "\"clearcoat\": -1", "/materials/enamel/clearcoat", "0.0..1.0, not -1.0"),
            edit("\"specular\": 0.5", "\"specular\": 1.5", "/materials/enamel/specular", "0.0..1.0, not 1.5"),
            edit("\"roughness\": 0.6875", "\"roughness\": 1.25", "/materials/varnish/roughness", "0.0..1.0, not 1.25"),
            edit(
                    "\"indexOfRefraction\": 1.75",
                    "\"indexOfRefraction\": 0.75",
                    "/materials/varnish/indexOfRefraction",
                    "1.0..10.0, not 0.75"),
            edit("\"weight\": 0.5625", "\"weight\": 1.5", "/materials/rust/weight", "must lie in 0.0..1.0, not 1.5"),
            edit("\"weight\": 0.5625", "\"weight\": \"half\"", "/materials/rust/weight", "a number in 0..1, or"),
            edit(", \"weight\": 0.5625", "", "/materials/rust/weight", "missing"),
            edit(
                    "[\"leaf\", { \"type\": \"matte\", \"color\": \"#c0c0c0\" }]",
                    "[\"leaf\"]",
                    "/materials/rust/materials",
                    "an array of two materials"),
            edit("\"of\": \"rust\", ", "", "/materials/grooves/of", "missing"),
            edit(", \"height\": -0.0625", "", "/materials/hammered/height", "missing"),
            edit("{\"texture\":  \"ice\"}", "0.5", "/materials/hammered/map", "must be {\"texture\": NAME}, not"),
            edit("\"nonlinear\": true", "\"nonlinear\": 1", "/materials/varnish/nonlinear", "true or false"),
            edit("[0.25, 0.5, 1]", "[0.25, 0.5]", "/materials/ember/color/linear", "three numbers"),
            edit("\"tone\": \"filmic\"", "\"tone\": \"film\"", "/display/tone", "did you mean \"filmic\"?"),
            edit("\"exposure\": -0.5", "\"exposure\": 2000", "/display/exposure", "-1000.0..1000.0, not 2000.0"),
            edit("\"exposure\": -0.5", "\"gamma\": 2", "/display/gamma", "the display part has"),
            // Out of range.
            edit("\"width\": 40", "\"width\": 0", "/image/width", "must be a whole number in 1..65536, not 0"),
            edit("\"height\": 20", "\"height\": -1", "/image/height", "must be a whole number in 1..65536, not -1"),
            edit("\"width\": 40", "\"width\": 65537", "/image/width", "not 65537"),
            edit("\"radius\": 1.5", "\"radius\": 0", "/objects/0/radius", "must be a number greater than 0, not 0.0"),
            edit("\"radius\": 1.5", "\"radius\": -1", "/objects/0/radius", "must be a number greater than 0, not -1.0"),
            edit("\"topRadius\": 0.1", "\"topRadius\": -0.1", "/objects/4/topRadius", "at least 0, not -0.1"),
            edit("\"minorRadius\": 0.35", "\"minorRadius\": 0", "/objects/7/minorRadius", "greater than 0"),
            edit("\"pupilRadius\": 0.5", "\"pupilRadius\": -0.5", "/camera/pupilRadius", "at least 0"),
            edit("\"ambient\": 0.25", "\"ambient\": 1.25", "/shading/ambient", "must lie in 0.0..1.0, not 1.25"),
            edit("\"transparency\": 0.875", "\"transparency\": 2", "/materials/glass/transparency", "not 2.0"),
            edit(
                    "\"indexOfRefraction\": 1.5",
                    "\"indexOfRefraction\": 0",
                    "/materials/glass/indexOfRefraction",
                    "not 0.0"),
            edit("\"priority\": -2", "\"priority\": 3e9", "/materials/glass/priority", "whole number in -2147483648.."),
            edit("\"scale\": 8", "\"scale\": 0", "/textures/checks/scale", "greater than 0"),
            edit("[0, 0.5, 1]]", "[0, 0.5, 1], \"#000000\"]", "/textures/checks/colors", "an array of two colours"),
            edit("[0.1, 0.2, 0.3]", "[0.1, 1.2, 0.3]", "/materials/chrome/color/1", "in 0..1, not 1.2"),
            edit("[0.1, 0.2, 0.3]", "[0.1, 0.3]", "/materials/chrome/color", "must be a colour"),
            edit("\"#102030\"", "\"#12345\"", "/shading/background", "must be a colour: \"#rrggbb\""),
            edit("\"#102030\"", "\"#1234\"", "/shading/background", "not the text \"#1234\""),
            edit("\"#102030\"", "\"#12g\"", "/shading/background", "not the text \"#12g\""),
            edit("\"#102030\"", "\"102030\"", "/shading/background", "not the text \"102030\""),
            edit("\"#102030\"", "\"Red\"", "/shading/background", "not the text \"Red\"; did you mean \"red\"?"),
            edit("\"#102030\"", "\"turqoise\"", "/shading/background", "did you mean \"turquoise\"?"),
            edit("[0.1, 0.2, 0.3]", "\"crhome\"", "/materials/chrome/color", "or {\"texture\": NAME}, not the text"),
            edit("\"#102030\"", "{ \"texture\": \"ice\" }", "/shading/background", "must be a colour"),
            edit("\"antialias\": 3", "\"antialias\": 0", "/render/antialias", "in 1..256, not 0"),
            edit("\"shadowSamples\": 7", "\"shadowSamples\": 1000001", "/render/shadowSamples", "in 1..1000000"),
            edit("\"seed\": 99", "\"seed\": 9223372036854775808", "/render/seed", "not 9223372036854775808"),
            edit("\"frames\": 11", "\"frames\": 0", "/animation/frames", "not 0"),
            edit("\"framesPerSecond\": 25", "\"framesPerSecond\": 0", "/animation/framesPerSecond", "greater than 0"),
            edit("{ \"0\": 1, \"10\": 2 }", "{}", "/animation/tracks/0/keys", "must hold at least one frame"));

    /** What only the reader can know. */
    static final List<Edit> FOR_THE_READER = List.of(
            edit(
                    "\"meanFreePath\": [0.3, 0.2, 0.1]",
                    "\"meanFreePath\": [0.3, 0, 0.1]",
                    "/materials/wax/meanFreePath",
                    "greater than 0, not 0.0"),
            edit(
                    "\"meanFreePath\": [0.3, 0.2, 0.1]",
                    "\"meanFreePath\": 1e-310",
                    "/materials/wax/meanFreePath",
                    "too short"),
            edit(
                    "\"color\": \"#f0e0c0\"",
                    "\"color\": {\"linear\": [0, 0, 1.5]}",
                    "/materials/wax/color",
                    "reflects more than it receives"),
            edit(
                    "\"scatteringCoefficient\": [6, 5, 4], \"absorptionCoefficient\": 0.125",
                    "\"scatteringCoefficient\": 1e308, \"absorptionCoefficient\": 1e308",
                    "/materials/milk/scatteringCoefficient",
                    "beyond the range of doubles"),
            edit(
                    "\"absorption\": [320, 450]",
                    "\"absorption\": [450, 320]",
                    "/materials/marker/absorption",
                    "two growing wavelengths"),
            edit(
                    "\"emission\": [500, 600.5]",
                    "\"emission\": [300, 310]",
                    "/materials/marker/emission",
                    "never shorter than what was absorbed"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\", \"background\": {\"texture\": \"checks\"}",
                    "/shading/background/texture",
                    "must name an image file"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\", \"background\": {\"texture\": \"icy\"}",
                    "/shading/background/texture",
                    "did you mean \"ice\"?"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\", \"background\": {\"type\": \"sky\", \"elevation\": 9, \"groundAlbedo\": [1, 1, 1.5]}",
                    "/shading/background/groundAlbedo",
                    "more than it receives"),
            edit("\"width\": 40", "\"width\": 1e30", "/image/width", "in 1..65536, not 1e30"),
            // Numbers that no double can hold.
            edit("\"radius\": 1.5", "\"radius\": 1e-400", "/objects/0/radius", "not 1e-400"),
            edit("\"radius\": 1.5", "\"radius\": 1e999", "/objects/0/radius", "not 1e999"),
            edit("\"radius\": 1.5", "\"radius\": NaN", "/objects/0/radius", "must be a finite number, not NaN"),
            edit(
                    "\"radius\": 1.5",
                    "\"radius\": -Infinity",
                    "/objects/0/radius",
                    "must be a finite number, not -Infinity"),
            edit("[-2, 1.10, 4]", "[-2, 2e308, 4]", "/objects/0/center/1", "not 2e308"),
            edit("\"10\": 2 }", "\"10\": 1e-330 }", "/animation/tracks/0/keys/10", "not 1e-330"),
            // Names.
            edit(
                    "\"vertices\": [[0, 0, 9], [1, 0, 9], [0, 1, 9]], \"material\": \"ice\"",
                    "\"vertices\": [[0, 0, 9], [1, 0, 9], [0, 1, 9]], \"material\": \"crome\"",
                    "/objects/8/material",
                    "unknown material \"crome\"; did you mean \"chrome\"?"),
            edit(
                    "\"vertices\": [[0, 0, 9], [1, 0, 9], [0, 1, 9]], \"material\": \"ice\"",
                    "\"vertices\": [[0, 0, 9], [1, 0, 9], [0, 1, 9]], \"material\": \"water\"",
                    "/objects/8/material",
                    "there are \"ice\", \"chrome\", \"glass\""),
            edit(
                    "{ \"texture\": \"checks\" }",
                    "{ \"texture\": \"check\" }",
                    "/objects/3/material/color/texture",
                    "unknown texture \"check\"; did you mean \"checks\"?"),
            edit("\"name\": \"ring\"", "\"name\": \"ball\"", "/objects/7/name", "is used twice; first in line 41"),
            // What surfaces cannot be made of.
            edit(
                    "[0.25, 0.5, 1]",
                    "[0.25, 1.5, 1]",
                    "/materials/ember/color",
                    "reflects more than it receives: no component of a surface's colour may be above 1, as 1.5 is"),
            edit("[0.2, 0.92, 1.1]", "[0.2, 0, 1.1]", "/materials/copper/eta", "greater than 0, not 0.0"),
            edit(
                    "\"radius\": 1.5, \"rotation\": 200, \"material\": \"ice\"",
                    "\"radius\": 1.5, \"material\": \"copper\"",
                    "/materials/copper/type",
                    "\"glossy\" needs \"shading\": {\"model\": \"physical\"}"),
            edit(
                    "\"classic\", \"ambient\": 0.25, \"shadow\": 0.75, \"background\": \"#102030\"",
                    "\"physical\"",
                    "/materials/ice/receivesShadows",
                    "must be true in physical shading"),
            // Degenerate shapes.
            edit("\"top\": [1, 2, 0]", "\"top\": [1.0, 0, 0]", "/objects/3/top", "must differ from \"base\""),
            edit("\"apex\": [2, 3, 0]", "\"apex\": [2, 0, 0]", "/objects/4/apex", "must differ from \"base\""),
            edit("\"minorRadius\": 0.35", "\"minorRadius\": 1.76", "/objects/7/minorRadius", "at most \"majorRadius\""),
            edit("\"axis\": [0, 0, 1]", "\"axis\": [0, 0, 0]", "/objects/7/axis", "other than (0, 0, 0)"),
            edit("\"max\": [1, 2, 8]", "\"max\": [1, 0, 8]", "/objects/6/max/1", "greater than the same coordinate"),
            edit("[0, 1, 9]]", "[2, 0, 9]]", "/objects/8/vertices", "must not lie in one line"),
            edit("[6, 6, 8], [6, -6, 8]]", "[6, 6, 8], [-6, 6, 8]]", "/objects/1/corners", "must span an area"),
            edit(
                    "[6, 6, 8], [6, -6, 8]]",
                    "[6, 6, 8.00001], [6, -6, 8]]",
                    "/objects/1/corners/2",
                    "must close the parallelogram"),
            edit("[1, 9, 1], [1, 9, 0]]", "[1, 9, 1], [0, 9, 2]]", "/lights/1/corners", "must span an area"),
            edit("\"eye\": [0, 1, -3]", "\"eye\": [9, 9, 0]", "/camera/eye", "must not lie in the window's plane"),
            edit(
                    "\"upperRight\": [3, 3, 0]",
                    "\"upperRight\": [3, 4, 0]",
                    "/camera/upperRight",
                    "must close the parallelogram"),
            edit("\"upperLeft\": [-3, 3, 0]", "\"upperLeft\": [9, 0, 0]", "/camera", "must span an area"),
            // Meshes, groups and transforms.
            edit(
                    "\"type\": \"mesh\", \"mesh\": \"gem\", \"transform\": [{ \"scale\": 0.5 }",
                    "\"type\": \"mesh\", \"mesh\": \"jem\", \"transform\": [{ \"scale\": 0.5 }",
                    "/objects/9/mesh",
                    "unknown mesh \"jem\"; did you mean \"gem\"?"),
            edit(
                    "\"meshes\": { \"gem\": { \"file\": \"gem.obj\"",
                    "\"meshes\": { \"gem\": { \"file\": \"gen.obj\"",
                    "/meshes/gem/file",
                    "gen.obj"),
            edit(
                    "\"part\": \"upper\"",
                    "\"part\": \"uper\"",
                    "/meshes/gem/file",
                    "has no part \"uper\" among its 2; did you mean \"upper\"?"),
            edit("\"part\": \"upper\"", "\"part\": \"2\"", "/meshes/gem/file", "there are \"upper\", \"lower\""),
            edit("\"axis\": [0, 1, 1]", "\"axis\": [0, 0, 0]", "/objects/10/transform/1/axis", "other than (0, 0, 0)"),
            edit(
                    "\"matrix\": [1, 0, 0, 5.5, 0, 0, -1, 0.1, 0, 1, 0, 7]",
                    "\"matrix\": [1, 2, 3, 5.5, 2, 4, 6, 0.1, 0, 1, 0, 7]",
                    "/objects/10/transform/2/matrix",
                    "must have an inverse"),
            edit(
                    "{ \"scale\": 0.5 }",
                    "{ \"scale\": 1e-200 }, { \"scale\": 1e-200 }",
                    "/objects/9/transform",
                    "must have an inverse in double precision"),
            edit(
                    "\"group\": \"pair\"",
                    "\"group\": \"pairs\"",
                    "/objects/11/group",
                    "unknown group \"pairs\"; did you mean \"pair\"?"),
            edit(
                    "\"transform\": [{ \"translate\": [4, 0.1, 9] }]",
                    "\"transform\": [{ \"scale\": [1, 1, 2] }]",
                    "/objects/11/transform",
                    "stretches a sphere"),
            edit("\"name\": \"other\"", "\"name\": \"one\"", "/groups/pair/1/name", "is used twice"),
            // Tracks that lead nowhere.
            edit("/objects/0/center/1", "/objects/0/center/3", "/animation/tracks/0/target", "there is nothing"),
            edit("/objects/0/center/1", "/objects/9/center/1", "/animation/tracks/0/target", "there is nothing"),
            edit(
                    "/objects/0/center/1",
                    "/objects/0/center",
                    "/animation/tracks/0/target",
                    "there is an array of 3 values"),
            edit("/objects/0/center/1", "/objects/0/name", "/animation/tracks/0/target", "there is the text \"ball\""),
            edit("/objects/0/center/1", "/animation/frames", "/animation/tracks/0/target", "outside the animation"),
            edit("/objects/0/center/1", "/objects/~2", "/animation/tracks/0/target", "must be a JSON pointer"),
            edit(
                    "\"keys\": { \"0\": 1, \"10\": 2 } }",
                    "\"keys\": { \"0\": 1 } }, { \"target\": \"/objects/0/center/1\", \"keys\": { \"0\": 1 } }",
                    "/animation/tracks/1/target",
                    "is the target of another track too"),
            // Files.
            edit("\"ice.png\"", "\"nice.png\"", "/textures/ice/file", "there is no file \"nice.png\""),
            edit("\"ice.png\"", "\".\"", "/textures/ice/file", "is not a file"),
            edit("\"ice.png\"", "\"a\\u0000b\"", "/textures/ice/file", "is not a path"),
            // Halves of characters, which no file can hold.
            edit("\"everything\"", "\"\\ud800\"", "/name", "holds half a character"),
            edit("\"ball\"", "\"a\\udc00b\"", "/objects/0/name", "holds half a character"),
            // Keys that are there twice.
            edit("\"radius\": 1.5", "\"radius\": 1.5, \"radius\": 2", "/objects/0/radius", "written twice"),
            edit("\"width\": 40", "\"width\": 41, \"width\": 40", "/image/width", "written twice"));

    private BadDocuments() {}
}
