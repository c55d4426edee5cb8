package enlightenment.importer.mitsuba;

import enlightenment.importer.support.Affine;
import enlightenment.importer.support.ExtractedFiles;
import enlightenment.importer.support.ImportDraft;
import enlightenment.importer.support.ImportFailure;
import enlightenment.importer.support.InputFolder;
import enlightenment.importer.support.NamedChoice;
import enlightenment.scene.Shading;
import enlightenment.text.Plain;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Set;

/**
 * Reads scenes of Mitsuba 3, and those of Mitsuba 2 and 0.6 as far as their names say the same. Light is linear RGB, as in Mitsuba's variants for RGB.
 */
public final class MitsubaReader {
    private static final Set<String> INTEGRATORS = Set.of(
            "path",
            "volpath",
            "volpathmis",
            "volpath_simple",
            "ptracer",
            "bdpt",
            "photonmapper",
            "pssmlt",
            "mlt",
            "erpt",
            "prb",
            "prb_basic",
            "prbvolpath",
            "prb_projective");

    private final SceneIndex scene;
    private final List<XmlElement> elements;

    /** The sensor of the picture; null where the file has none. */
    private final XmlElement sensor;

    private MitsubaReader(SceneIndex scene, List<XmlElement> elements, XmlElement sensor) {
        this.scene = scene;
        this.elements = elements;
        this.sensor = sensor;
    }

    /**
     * Reads a scene.
     *
     * @param folder of its file
     * @param made where pictures go that are made of the scene's own
     * @param camera which sensor, by its number or its id
     * @throws enlightenment.scene.SceneException for what is no such scene, with file, line and what was expected
     * @throws IOException if a file cannot be read, or a mesh is broken
     */
    public static ImportDraft read(InputFolder folder, ExtractedFiles made, NamedChoice camera) throws IOException {
        Path file = folder.imported();
        XmlElement root = XmlFile.read(folder);
        if (!root.tag().equals("scene")) {
            throw ImportFailure.at(
                    file, 1, "is no scene of Mitsuba: its root is " + Plain.quoted(root.tag()) + ", not \"scene\"");
        }
        ImportDraft draft = new ImportDraft();
        List<XmlElement> sensors =
                root.children().stream().filter(e -> e.tag().equals("sensor")).toList();
        int wanted = chosen(file, sensors, camera);
        XmlElement sensor = sensors.isEmpty() ? null : sensors.get(wanted);
        new MitsubaReader(new SceneIndex(root, folder, draft, made), root.children(), sensor).addAll();
        return draft;
    }

    private static int chosen(Path file, List<XmlElement> sensors, NamedChoice camera) {
        try {
            return camera.index(sensors.stream().map(e -> e.attribute("id")).toList());
        } catch (IOException e) {
            throw ImportFailure.at(file, 0, e.getMessage());
        }
    }

    private void addAll() throws IOException {
        Affine world = WorldMap.of(scene, elements);
        ShapeReader shapes = new ShapeReader(scene, world);
        EmitterReader emitters = new EmitterReader(scene, world);
        for (XmlElement e : elements) {
            switch (e.tag()) {
                case "shape" -> shapes.add(e);
                case "emitter" -> {
                    // One of an area shines where a shape refers to it.
                    if (!e.type().equals("area") || !e.has("id")) {
                        emitters.add(e);
                    }
                }
                case "integrator" -> integrator(e);
                case "sensor" -> {
                    if (e == sensor) {
                        new SensorReader(scene, world).add(e);
                    } else {
                        scene.note(e, "one sensor counts: this one is left out");
                    }
                }
                case "bsdf",
                        "texture",
                        "medium",
                        "alias",
                        "path",
                        "sampler",
                        "film",
                        "phase",
                        "rfilter",
                        "spectrum" -> {
                    // Counts where it is referred to, or not at all.
                }
                default -> scene.note(e, e.described() + " is left out");
            }
        }
    }

    private void integrator(XmlElement e) {
        List<XmlElement> inside = scene.inside(e, "integrator");
        if (!inside.isEmpty()) {
            integrator(inside.get(0));
            return;
        }
        Properties p = new Properties(e);
        if (p.flag("hide_emitters", false)) {
            scene.note(e, "hide_emitters is left out: what emits is seen");
        }
        if (e.type().equals("direct")) {
            scene.draft().maxBounces(1);
        } else if (!INTEGRATORS.contains(e.type())) {
            scene.note(e, e.described() + " is left out: all light is computed");
        }
        // A path of depth 1 is light that is seen, of depth 2 light that was scattered once.
        int depth = p.whole("max_depth", -1);
        if (depth >= 0 && !e.type().equals("direct")) {
            scene.draft().maxBounces(StrictMath.min(StrictMath.max(depth - 1, 0), Shading.Physical.MAX_BOUNCES));
        }
    }
}
