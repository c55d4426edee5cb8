package enlightenment.architecture;

import static com.tngtech.archunit.core.domain.JavaCall.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.name;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameMatching;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.importer.ImportOption;
import com.tngtech.archunit.junit.AnalyzeClasses;
import com.tngtech.archunit.junit.ArchTest;
import com.tngtech.archunit.lang.ArchRule;
import com.tngtech.archunit.library.Architectures;
import java.io.FileOutputStream;
import java.io.FileWriter;
import java.io.RandomAccessFile;
import java.nio.channels.FileChannel;
import java.nio.file.Files;

/** Data flows one way: the layers of docs/architecture.md, and who may use what. */
@AnalyzeClasses(packages = "enlightenment", importOptions = ImportOption.DoNotIncludeTests.class)
class ArchitectureTest {
    @ArchTest
    static final ArchRule packagesHaveNoCycles =
            slices().matching("enlightenment.(**)").should().beFreeOfCycles();

    @ArchTest
    static final ArchRule aLayerUsesOnlyLayersAboveIt = Architectures.layeredArchitecture()
            .consideringOnlyDependenciesInAnyPackage("enlightenment..")
            .layer("file")
            .definedBy("enlightenment.file")
            .layer("machine")
            .definedBy("enlightenment.machine")
            .layer("text")
            .definedBy("enlightenment.text")
            .layer("json output")
            .definedBy("enlightenment.json")
            .layer("numeric")
            .definedBy("enlightenment.numeric")
            .layer("math")
            .definedBy("enlightenment.math")
            .layer("check")
            .definedBy("enlightenment.check")
            .layer("frame")
            .definedBy("enlightenment.frame")
            .layer("colorimetry")
            .definedBy("enlightenment.colorimetry")
            .layer("color")
            .definedBy("enlightenment.color")
            .layer("codec")
            .definedBy("enlightenment.codec")
            .layer("image")
            .definedBy("enlightenment.image..")
            .layer("picture")
            .definedBy("enlightenment.picture")
            .layer("surroundings")
            .definedBy("enlightenment.surroundings")
            .layer("video")
            .definedBy("enlightenment.video")
            .layer("texture")
            .definedBy("enlightenment.texture")
            .layer("bvh")
            .definedBy("enlightenment.bvh")
            .layer("mesh")
            .definedBy("enlightenment.mesh..")
            .layer("photometry")
            .definedBy("enlightenment.photometry")
            .layer("geometry")
            .definedBy("enlightenment.geometry")
            .layer("primitive")
            .definedBy("enlightenment.primitive")
            .layer("sampling")
            .definedBy("enlightenment.sampling")
            .layer("bsdf")
            .definedBy("enlightenment.bsdf")
            .layer("emitter")
            .definedBy("enlightenment.emitter")
            .layer("descriptions")
            .definedBy("enlightenment.material", "enlightenment.light", "enlightenment.camera")
            .layer("scene")
            .definedBy("enlightenment.scene")
            .layer("json")
            .definedBy("enlightenment.scene.json..")
            .layer("nff")
            .definedBy("enlightenment.nff")
            .layer("importer")
            .definedBy("enlightenment.importer..")
            .layer("accel")
            .definedBy("enlightenment.accel")
            .layer("world")
            .definedBy("enlightenment.world..")
            .layer("film")
            .definedBy("enlightenment.film")
            .layer("transport")
            .definedBy("enlightenment.transport..")
            .layer("classic shading")
            .definedBy("enlightenment.classic.shading")
            .layer("probe")
            .definedBy("enlightenment.probe")
            .layer("method")
            .definedBy("enlightenment.method..")
            .layer("device")
            .definedBy("enlightenment.device..")
            .layer("classic cluster")
            .definedBy("enlightenment.classic.cluster")
            .layer("work")
            .definedBy("enlightenment.work")
            .layer("denoise")
            .definedBy("enlightenment.denoise")
            .layer("report")
            .definedBy("enlightenment.report")
            .layer("plan")
            .definedBy("enlightenment.plan")
            .layer("engine")
            .definedBy("enlightenment.engine")
            .layer("render")
            .definedBy("enlightenment.render..")
            .layer("job")
            .definedBy("enlightenment.job")
            .layer("checkpoint")
            .definedBy("enlightenment.checkpoint")
            .layer("listen")
            .definedBy("enlightenment.listen")
            .layer("status")
            .definedBy("enlightenment.status")
            .layer("view")
            .definedBy("enlightenment.view..")
            .layer("window")
            .definedBy("enlightenment.window")
            .layer("store")
            .definedBy("enlightenment.store")
            .layer("net")
            .definedBy("enlightenment.net..")
            .layer("measure")
            .definedBy("enlightenment.measure..")
            .layer("cli")
            .definedBy("enlightenment.cli..")
            .whereLayer("cli")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("json output")
            .mayOnlyBeAccessedByLayers("net", "view", "cli")
            .whereLayer("file")
            .mayOnlyBeAccessedByLayers(
                    "codec",
                    "image",
                    "video",
                    "mesh",
                    "json",
                    "nff",
                    "importer",
                    "photometry",
                    "job",
                    "checkpoint",
                    "film",
                    "engine",
                    "net",
                    "measure",
                    "view",
                    "cli")
            .whereLayer("job")
            .mayOnlyBeAccessedByLayers("checkpoint", "net", "cli")
            .whereLayer("checkpoint")
            .mayOnlyBeAccessedByLayers("net", "cli")
            .whereLayer("video")
            .mayOnlyBeAccessedByLayers("cli")
            .whereLayer("machine")
            .mayOnlyBeAccessedByLayers("device", "work", "status", "net", "measure", "cli")
            .whereLayer("net")
            .mayOnlyBeAccessedByLayers("cli")
            .whereLayer("listen")
            .mayOnlyBeAccessedByLayers("status", "net", "view", "cli")
            .whereLayer("status")
            .mayOnlyBeAccessedByLayers("window", "net", "view", "cli")
            .whereLayer("view")
            .mayOnlyBeAccessedByLayers("cli")
            .whereLayer("window")
            .mayOnlyBeAccessedByLayers("cli")
            .whereLayer("measure")
            .mayOnlyBeAccessedByLayers("cli")
            .whereLayer("store")
            .mayOnlyBeAccessedByLayers("cli")
            .whereLayer("render")
            .mayOnlyBeAccessedByLayers("checkpoint", "net", "measure", "view", "cli", "status", "store")
            .whereLayer("engine")
            .mayOnlyBeAccessedByLayers("render", "checkpoint", "net", "store")
            .whereLayer("plan")
            .mayOnlyBeAccessedByLayers("render", "engine", "net", "store")
            .whereLayer("report")
            .mayOnlyBeAccessedByLayers("plan", "engine", "render", "status", "view", "net", "measure", "cli")
            .whereLayer("work")
            .mayOnlyBeAccessedByLayers("denoise", "plan", "render", "engine", "net", "cli")
            .whereLayer("nff")
            .mayOnlyBeAccessedByLayers("importer", "cli")
            .whereLayer("importer")
            .mayOnlyBeAccessedByLayers("cli")
            .whereLayer("json")
            .mayOnlyBeAccessedByLayers("job", "net", "view", "cli")
            .whereLayer("method")
            .mayOnlyBeAccessedByLayers("device", "classic cluster", "plan", "render", "engine")
            .whereLayer("device")
            .mayOnlyBeAccessedByLayers("engine", "render", "net", "cli")
            .whereLayer("classic cluster")
            .mayOnlyBeAccessedByLayers("plan", "render")
            .whereLayer("probe")
            .mayOnlyBeAccessedByLayers("method")
            .whereLayer("classic shading")
            .mayOnlyBeAccessedByLayers("probe", "method", "device", "classic cluster")
            .whereLayer("transport")
            .mayOnlyBeAccessedByLayers("classic shading", "device", "probe", "method", "classic cluster")
            .whereLayer("film")
            .mayOnlyBeAccessedByLayers(
                    "classic shading",
                    "probe",
                    "classic cluster",
                    "transport",
                    "method",
                    "plan",
                    "render",
                    "engine",
                    "net",
                    "store")
            .whereLayer("denoise")
            .mayOnlyBeAccessedByLayers("render", "view")
            .whereLayer("bsdf")
            .mayOnlyBeAccessedByLayers("device", "classic shading", "probe", "classic cluster", "world", "transport")
            .whereLayer("emitter")
            .mayOnlyBeAccessedByLayers("device", "classic shading", "probe", "classic cluster", "world", "transport")
            .whereLayer("primitive")
            .mayOnlyBeAccessedByLayers(
                    "classic shading",
                    "probe",
                    "classic cluster",
                    "emitter",
                    "accel",
                    "world",
                    "transport",
                    "method",
                    "device",
                    "render")
            .whereLayer("world")
            .mayOnlyBeAccessedByLayers(
                    "classic shading",
                    "probe",
                    "classic cluster",
                    "film",
                    "transport",
                    "method",
                    "device",
                    "work",
                    "plan",
                    "render",
                    "engine")
            .whereLayer("accel")
            .mayOnlyBeAccessedByLayers("device", "world")
            .whereLayer("bvh")
            .mayOnlyBeAccessedByLayers("mesh", "accel", "world", "device")
            .whereLayer("scene")
            .mayOnlyBeAccessedByLayers(
                    "device",
                    "classic shading",
                    "probe",
                    "classic cluster",
                    "json",
                    "nff",
                    "importer",
                    "world",
                    "transport",
                    "method",
                    "work",
                    "report",
                    "plan",
                    "engine",
                    "render",
                    "job",
                    "net",
                    "measure",
                    "view",
                    "cli")
            .whereLayer("descriptions")
            .mayOnlyBeAccessedByLayers("scene", "json", "nff", "importer", "world", "view", "cli")
            .whereLayer("sampling")
            .mayOnlyBeAccessedByLayers(
                    "device",
                    "classic shading",
                    "probe",
                    "classic cluster",
                    "bsdf",
                    "emitter",
                    "surroundings",
                    "scene",
                    "world",
                    "transport",
                    "method",
                    "plan",
                    "render",
                    "net",
                    "cli")
            .whereLayer("text")
            .mayOnlyBeAccessedByLayers(
                    "device",
                    "codec",
                    "image",
                    "mesh",
                    "scene",
                    "json",
                    "importer",
                    "photometry",
                    "engine",
                    "render",
                    "listen",
                    "net",
                    "view",
                    "cli",
                    "store")
            .whereLayer("codec")
            .mayOnlyBeAccessedByLayers("image", "picture", "texture", "surroundings", "video")
            .whereLayer("surroundings")
            .mayOnlyBeAccessedByLayers("classic shading", "probe", "classic cluster", "world", "transport")
            .whereLayer("picture")
            .mayOnlyBeAccessedByLayers("film", "plan", "render", "engine", "status", "measure", "view", "cli")
            .whereLayer("texture")
            .mayOnlyBeAccessedByLayers("device", "world")
            .whereLayer("image")
            .mayOnlyBeAccessedByLayers(
                    "picture",
                    "texture",
                    "film",
                    "plan",
                    "render",
                    "engine",
                    "job",
                    "status",
                    "window",
                    "view",
                    "net",
                    "measure",
                    "store",
                    "cli",
                    "json",
                    "importer");

    /** Passes that compile a scene, from what all of them stand on down to the compiled scene. */
    @ArchTest
    static final ArchRule passesOfTheWorldUseOnlyPassesBeforeThem = Architectures.layeredArchitecture()
            .consideringOnlyDependenciesInAnyPackage("enlightenment.world..")
            .layer("parts")
            .definedBy("enlightenment.world.parts")
            .layer("material")
            .definedBy("enlightenment.world.material")
            .layer("camera")
            .definedBy("enlightenment.world.camera")
            .layer("contact")
            .definedBy("enlightenment.world.contact")
            .layer("light")
            .definedBy("enlightenment.world.light")
            .layer("check")
            .definedBy("enlightenment.world.check")
            .layer("surface")
            .definedBy("enlightenment.world.surface")
            .layer("world")
            .definedBy("enlightenment.world")
            .whereLayer("check")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("surface")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("world")
            .mayOnlyBeAccessedByLayers("surface", "check")
            .whereLayer("light")
            .mayOnlyBeAccessedByLayers("check", "world")
            .whereLayer("contact")
            .mayOnlyBeAccessedByLayers("light", "check", "world")
            .whereLayer("camera")
            .mayOnlyBeAccessedByLayers("light", "check", "world")
            .whereLayer("parts")
            .mayOnlyBeAccessedByLayers("camera", "contact", "light", "check", "surface", "world");

    /**
     * Light transport, from a path's state down to whole techniques. Those of one direction build on the bidirectional one: light paths are one
     * strategy of it, and paths from the eye that are shared among pixels go on by it.
     */
    @ArchTest
    static final ArchRule techniquesOfTransportUseOnlyWhatTheyBuildOn = Architectures.layeredArchitecture()
            .consideringOnlyDependenciesInAnyPackage("enlightenment.transport..")
            .layer("state")
            .definedBy("enlightenment.transport.state")
            .layer("ray")
            .definedBy("enlightenment.transport.ray")
            .layer("media")
            .definedBy("enlightenment.transport.media")
            .layer("direct")
            .definedBy("enlightenment.transport.direct")
            .layer("image")
            .definedBy("enlightenment.transport.image")
            .layer("emission")
            .definedBy("enlightenment.transport.emission")
            .layer("path")
            .definedBy("enlightenment.transport.path")
            .layer("bidirectional")
            .definedBy("enlightenment.transport.bidirectional")
            .layer("light")
            .definedBy("enlightenment.transport.light")
            .whereLayer("light")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("bidirectional")
            .mayOnlyBeAccessedByLayers("path", "light")
            .whereLayer("path")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("emission")
            .mayOnlyBeAccessedByLayers("bidirectional", "light")
            .whereLayer("image")
            .mayOnlyBeAccessedByLayers("path", "bidirectional")
            .whereLayer("direct")
            .mayOnlyBeAccessedByLayers("image", "path", "bidirectional", "light")
            .whereLayer("media")
            .mayOnlyBeAccessedByLayers("direct", "image", "path", "bidirectional", "light");

    /** Server and workers, from what is said over the wire up to what is exported. */
    @ArchTest
    static final ArchRule aLayerOfNetUsesOnlyLayersAboveIt = Architectures.layeredArchitecture()
            .consideringOnlyDependenciesInAnyPackage("enlightenment.net..")
            .layer("secure")
            .definedBy("enlightenment.net.secure")
            .layer("protocol")
            .definedBy("enlightenment.net.protocol")
            .layer("job")
            .definedBy("enlightenment.net.job")
            .layer("schedule")
            .definedBy("enlightenment.net.schedule")
            .layer("worker")
            .definedBy("enlightenment.net.worker")
            .layer("server")
            .definedBy("enlightenment.net.server")
            .layer("parts")
            .definedBy("enlightenment.net.parts")
            .layer("net")
            .definedBy("enlightenment.net")
            .whereLayer("parts")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("net")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("server")
            .mayOnlyBeAccessedByLayers("net")
            .whereLayer("worker")
            .mayOnlyBeAccessedByLayers("server", "net")
            .whereLayer("schedule")
            .mayOnlyBeAccessedByLayers("worker", "server", "net")
            .whereLayer("job")
            .mayOnlyBeAccessedByLayers("schedule", "worker", "server", "parts", "net")
            .whereLayer("protocol")
            .mayOnlyBeAccessedByLayers("job", "schedule", "worker", "server", "parts", "net");

    /** The command line, from the terminal up to all commands: films know the options of servers, else no command knows another. */
    @ArchTest
    static final ArchRule aPackageOfTheCommandLineUsesOnlyPackagesAboveIt = Architectures.layeredArchitecture()
            .consideringOnlyDependenciesInAnyPackage("enlightenment.cli..")
            .layer("terminal")
            .definedBy("enlightenment.cli.terminal")
            .layer("option")
            .definedBy("enlightenment.cli.option")
            .layer("input")
            .definedBy("enlightenment.cli.input")
            .layer("setting")
            .definedBy("enlightenment.cli.setting")
            .layer("picture")
            .definedBy("enlightenment.cli.picture")
            .layer("progress")
            .definedBy("enlightenment.cli.progress")
            .layer("store")
            .definedBy("enlightenment.cli.store")
            .layer("serve")
            .definedBy("enlightenment.cli.serve")
            .layer("render")
            .definedBy("enlightenment.cli.render")
            .layer("film")
            .definedBy("enlightenment.cli.film")
            .layer("scene")
            .definedBy("enlightenment.cli.scene")
            .layer("view")
            .definedBy("enlightenment.cli.view")
            .layer("measure")
            .definedBy("enlightenment.cli.measure")
            .layer("cli")
            .definedBy("enlightenment.cli")
            .whereLayer("cli")
            .mayNotBeAccessedByAnyLayer()
            .whereLayer("measure")
            .mayOnlyBeAccessedByLayers("cli")
            .whereLayer("view")
            .mayOnlyBeAccessedByLayers("cli")
            .whereLayer("scene")
            .mayOnlyBeAccessedByLayers("cli")
            .whereLayer("film")
            .mayOnlyBeAccessedByLayers("cli")
            .whereLayer("render")
            .mayOnlyBeAccessedByLayers("cli")
            .whereLayer("serve")
            .mayOnlyBeAccessedByLayers("film", "cli")
            .whereLayer("store")
            .mayOnlyBeAccessedByLayers("serve", "render", "cli")
            .whereLayer("progress")
            .mayOnlyBeAccessedByLayers("serve", "render", "film", "measure")
            .whereLayer("picture")
            .mayOnlyBeAccessedByLayers("progress", "store", "serve", "render", "film", "view", "measure")
            .whereLayer("setting")
            .mayOnlyBeAccessedByLayers("store", "serve", "render", "film", "scene", "view", "measure")
            .whereLayer("input")
            .mayOnlyBeAccessedByLayers(
                    "setting", "progress", "serve", "render", "film", "scene", "view", "measure", "cli")
            .whereLayer("option")
            .mayOnlyBeAccessedByLayers(
                    "input",
                    "setting",
                    "picture",
                    "progress",
                    "store",
                    "serve",
                    "render",
                    "film",
                    "scene",
                    "view",
                    "measure",
                    "cli");

    /** So that whole renders can be simulated. */
    @ArchTest
    static final ArchRule whatDecidesWhoRendersWhatKnowsNoClockSocketOrThread = noClasses()
            .that()
            .resideInAPackage("enlightenment.net.schedule")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("java.net..", "java.nio..", "java.io..", "java.util.concurrent..")
            .orShould()
            .callMethod(System.class, "nanoTime")
            .orShould()
            .callMethod(System.class, "currentTimeMillis")
            .orShould()
            .dependOnClassesThat()
            .areAssignableTo(Thread.class);

    /** So that embedding works without it, as long as no message is sent. */
    @ArchTest
    static final ArchRule onlyTheMessageCodecSeesCbor = noClasses()
            .that()
            .doNotHaveFullyQualifiedName("enlightenment.net.protocol.MessageCodec")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("tools.jackson.dataformat..");

    /** So that whoever embeds the library needs neither databases nor the module for them. */
    @ArchTest
    static final ArchRule onlyTheStoreSeesDatabases = noClasses()
            .that()
            .resideOutsideOfPackage("enlightenment.store")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("java.sql..", "javax.sql..", "org.sqlite..");

    @ArchTest
    static final ArchRule serversAndWorkersNeedNoModuleOfTheJdkThatMayBeMissing = noClasses()
            .that()
            .resideInAnyPackage("enlightenment.net..", "enlightenment.listen", "enlightenment.status")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("com.sun..", "jdk..");

    /** So that files appear as a whole; what is appended to, such as checkpoints, is left to the journals. */
    @ArchTest
    static final ArchRule filesAreWrittenByWholeFileOnly = noClasses()
            .that()
            .resideOutsideOfPackage("enlightenment.file")
            .and()
            .haveSimpleNameNotEndingWith("Journal")
            .should()
            .callMethodWhere(
                    target(nameMatching("write|writeString|newOutputStream|newBufferedWriter|newByteChannel|copy|move|"
                                    + "createTempFile|createTempDirectory"))
                            .and(target(owner(assignableTo(Files.class)))))
            .orShould()
            .callMethodWhere(target(name("open")).and(target(owner(assignableTo(FileChannel.class)))))
            .orShould()
            .dependOnClassesThat()
            .belongToAnyOf(FileOutputStream.class, FileWriter.class, RandomAccessFile.class);

    /** In the command line only the classes that write one kind of report each. */
    @ArchTest
    static final ArchRule onlyReadersAndWritersOfJsonSeeJackson = noClasses()
            .that()
            .resideOutsideOfPackages(
                    "enlightenment.scene.json..",
                    "enlightenment.importer.gltf",
                    "enlightenment.json",
                    "enlightenment.net.protocol",
                    "enlightenment.status")
            .and()
            .haveSimpleNameNotEndingWith("Json")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("tools.jackson..");

    @ArchTest
    static final ArchRule onlyTheCommandLineSeesPicocliAndProgressBars = noClasses()
            .that()
            .resideOutsideOfPackage("enlightenment.cli..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("picocli..", "me.tongfei..", "org.jline..");

    @ArchTest
    static final ArchRule onlyTheCommandLinePrintsAndExits = noClasses()
            .that()
            .resideOutsideOfPackage("enlightenment.cli..")
            .should()
            .accessField(System.class, "out")
            .orShould()
            .accessField(System.class, "err")
            .orShould()
            .callMethod(System.class, "exit", int.class);

    @ArchTest
    static final ArchRule onlyChartsSeeTheChartingLibraries = noClasses()
            .that()
            .resideOutsideOfPackage("enlightenment.measure.chart")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("org.knowm..", "org.apache.batik..", "org.w3c.dom..");

    @ArchTest
    static final ArchRule onlyChartsAndTheReaderOfMitsubasScenesUseXml = noClasses()
            .that()
            .resideOutsideOfPackages("enlightenment.measure.chart", "enlightenment.importer.mitsuba")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("javax.xml..");

    @ArchTest
    static final ArchRule onlyReadingImagesChartsAndTheWindowUseAwt = noClasses()
            .that()
            .resideOutsideOfPackages("enlightenment.codec", "enlightenment.measure.chart", "enlightenment.window")
            .and()
            .doNotHaveFullyQualifiedName("enlightenment.image.Image")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("java.awt..", "javax.imageio..");

    @ArchTest
    static final ArchRule onlyTheWindowSeesSwing = noClasses()
            .that()
            .resideOutsideOfPackage("enlightenment.window")
            .should()
            .dependOnClassesThat()
            .resideInAPackage("javax.swing..");

    @ArchTest
    static final ArchRule whatDecidesPixelsUsesNoFunctionsThatDifferBetweenMachines = noClasses()
            .that()
            .resideInAnyPackage(
                    "enlightenment.numeric",
                    "enlightenment.math",
                    "enlightenment.frame",
                    "enlightenment.primitive",
                    "enlightenment.colorimetry",
                    "enlightenment.color",
                    "enlightenment.geometry",
                    "enlightenment.sampling",
                    "enlightenment.bsdf",
                    "enlightenment.emitter",
                    "enlightenment.accel",
                    "enlightenment.world..",
                    "enlightenment.film",
                    "enlightenment.transport..",
                    "enlightenment.classic..",
                    "enlightenment.method..")
            .should()
            .callMethod(Math.class, "sin", double.class)
            .orShould()
            .callMethod(Math.class, "cos", double.class)
            .orShould()
            .callMethod(Math.class, "tan", double.class)
            .orShould()
            .callMethod(Math.class, "asin", double.class)
            .orShould()
            .callMethod(Math.class, "acos", double.class)
            .orShould()
            .callMethod(Math.class, "atan", double.class)
            .orShould()
            .callMethod(Math.class, "atan2", double.class, double.class)
            .orShould()
            .callMethod(Math.class, "pow", double.class, double.class)
            .orShould()
            .callMethod(Math.class, "exp", double.class)
            .orShould()
            .callMethod(Math.class, "log", double.class)
            .orShould()
            .callMethod(Math.class, "cbrt", double.class)
            .orShould()
            .callMethod(Math.class, "hypot", double.class, double.class);
}
