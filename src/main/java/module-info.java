/**
 * Enlightenment, a renderer for the JVM: scene descriptions, exact geometry, light transport, finished images.
 */
@SuppressWarnings("requires-automatic") // Batik has a name, but no descriptor; nothing exported shows it.
module enlightenment {
    requires transitive java.desktop; // javax.imageio, for JPEG and BMP textures; BufferedImage of finished pictures
    requires tools.jackson.core;
    requires jdk.jfr; // renders can be watched in Java Flight Recorder
    // Tell processor time and load best; without them there is less to tell.
    requires static java.management;
    requires static jdk.management;
    // Only server and workers need this.
    requires static tools.jackson.dataformat.cbor;
    // Only the command line needs these; programs that embed the library do not.
    requires static info.picocli;
    requires static me.tongfei.progressbar;
    // Only charts need it, and XChart, which has no name as a module and is read from the class path.
    requires static org.apache.xmlgraphics.batik.svggen;
    // Charts, and scenes of Mitsuba; java.desktop brings it along.
    requires static java.xml;
    // Only renders on other devices need these.
    requires static org.lwjgl;
    requires static org.lwjgl.opencl;
    // Only the sample store needs this.
    requires static java.sql;

    exports enlightenment.math;
    exports enlightenment.color;
    exports enlightenment.mesh;
    exports enlightenment.geometry;
    exports enlightenment.material;
    exports enlightenment.light;
    exports enlightenment.camera;
    exports enlightenment.scene;
    exports enlightenment.importer;
    exports enlightenment.scene.json;
    exports enlightenment.image;
    exports enlightenment.report;
    exports enlightenment.render;
    exports enlightenment.net;

    // Methods of rendering from outside.
    uses enlightenment.scene.MethodExtension;

    opens enlightenment.cli to
            info.picocli;
    opens enlightenment.cli.film to
            info.picocli;
    opens enlightenment.cli.input to
            info.picocli;
    opens enlightenment.cli.measure to
            info.picocli;
    opens enlightenment.cli.option to
            info.picocli;
    opens enlightenment.cli.picture to
            info.picocli;
    opens enlightenment.cli.progress to
            info.picocli;
    opens enlightenment.cli.render to
            info.picocli;
    opens enlightenment.cli.scene to
            info.picocli;
    opens enlightenment.cli.serve to
            info.picocli;
    opens enlightenment.cli.setting to
            info.picocli;
    opens enlightenment.cli.store to
            info.picocli;
    opens enlightenment.cli.terminal to
            info.picocli;
    opens enlightenment.cli.view to
            info.picocli;
}
