/**
 * Enlightenment, a renderer for the JVM: scene descriptions, exact geometry, light transport, finished images.
 */
module enlightenment {
    requires tools.jackson.core;

    exports enlightenment.math;
    exports enlightenment.color;
    exports enlightenment.geometry;
    exports enlightenment.material;
    exports enlightenment.light;
    exports enlightenment.camera;
    exports enlightenment.scene;
    exports enlightenment.scene.json;
    exports enlightenment.image;
    exports enlightenment.render;
}
