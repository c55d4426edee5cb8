/**
 * Enlightenment, a renderer for the JVM: scene descriptions, exact geometry, light transport, finished images.
 */
module enlightenment {
    requires tools.jackson.core;
    requires java.desktop;
    requires java.management;
    requires jdk.jfr;
    requires jdk.management;

    exports enlightenment.math;
    exports enlightenment.color;
    exports enlightenment.geometry;
    exports enlightenment.sampling;
    exports enlightenment.material;
    exports enlightenment.light;
    exports enlightenment.camera;
    exports enlightenment.scene;
    exports enlightenment.scene.json;
    exports enlightenment.image;
    exports enlightenment.render;
}
