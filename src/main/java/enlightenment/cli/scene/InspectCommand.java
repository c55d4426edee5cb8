package enlightenment.cli.scene;

import enlightenment.cli.input.ForeignOptions;
import enlightenment.cli.input.FrameOption;
import enlightenment.cli.input.SceneArgument;
import enlightenment.cli.input.SceneFailures;
import enlightenment.cli.input.SceneInput;
import enlightenment.cli.option.MethodOptions;
import enlightenment.cli.option.Subcommand;
import enlightenment.cli.setting.RenderOptions;
import enlightenment.cli.setting.SettingsLine;
import enlightenment.cli.setting.StretchHint;
import enlightenment.cli.terminal.ExitCode;
import enlightenment.cli.terminal.Terminal;
import enlightenment.geometry.Mesh;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.InvalidValueException;
import enlightenment.mesh.TriangleMesh;
import enlightenment.mesh.tree.TriangleTree;
import enlightenment.render.RenderRequest;
import enlightenment.render.Renderer;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.Method;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import enlightenment.text.Plain;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code enlightenment inspect}: shows what a scene holds and what a render of it would do. */
@Command(
        name = "inspect",
        description = "Shows what a scene holds and what a render of it would do.",
        sortOptions = false)
public final class InspectCommand extends Subcommand {
    private static final int LONGEST_LINE = 10_000;
    private static final double MEBI = 1 << 20;

    @Mixin
    private SceneArgument argument = new SceneArgument();

    @Mixin
    private ForeignOptions foreign = new ForeignOptions();

    @Mixin
    private RenderOptions options = new RenderOptions();

    @Mixin
    private FrameOption frame = new FrameOption();

    private SceneInput input;

    public InspectCommand(Terminal terminal) {
        super(terminal);
    }

    @Override
    public Optional<MethodOptions> methodOptions() {
        return Optional.of(options.methods());
    }

    @Override
    protected int execute() {
        input = argument.open(foreign, terminal);
        Scene scene = frame.read(input);
        RenderRequest.MethodChoice choice = options.choose(scene, options.settings(scene, input), input, terminal);
        RenderSettings settings = choice.settings();
        Renderer.Inspection inspection = inspect(scene, settings);
        contents(scene);
        list("method", method(settings, scene));
        choice.reason().ifPresent(reason -> line("chosen", reason));
        list("can render it", methods(inspection));
        line("settings", SettingsLine.of(settings, frame.number()) + " threads=" + settings.threads());
        list("modelled", inspection.modelled());
        List<String> idle = inspection.notModelled();
        line("not needed", idle.isEmpty() ? "(nothing)" : String.join("; ", idle));
        line("primitives", Integer.toString(inspection.primitives()));
        line("expected memory", String.format(Locale.ROOT, "%.1f MiB", inspection.expectedMemoryBytes() / MEBI));
        List<String> hints = new ArrayList<>(inspection.hints());
        StretchHint.of(scene, settings).ifPresent(hints::add);
        if (!hints.isEmpty()) {
            list("hints", hints);
        }
        return ExitCode.DONE;
    }

    /** The method's description, and that of each of its settings. */
    private static List<String> method(RenderSettings settings, Scene scene) {
        List<String> lines = new ArrayList<>();
        lines.add(settings.method().word() + ": " + settings.method().description());
        for (Method.Setting setting : settings.method().settings()) {
            boolean isIdle = setting == BuiltInMethod.RayTraceSettings.SHADOW_SAMPLES
                    && scene.shading() instanceof Shading.Physical;
            lines.add(setting.key() + "=" + settings.chosen().value(setting) + ": "
                    + (isIdle
                            ? "of classic shading; a physical path takes one point of a light at a time"
                            : setting.description()));
        }
        return lines;
    }

    /** Which methods can render the scene, and what they cannot see of it. */
    private static List<String> methods(Renderer.Inspection inspection) {
        List<String> all = new ArrayList<>();
        List<String> blind = new ArrayList<>();
        List<String> outside = new ArrayList<>();
        for (Renderer.Sight sight : inspection.methods()) {
            String word = sight.method().word();
            if (sight.blindSpot().isPresent()) {
                blind.add(sight.blindSpot().get());
            } else {
                (sight.method() instanceof BuiltInMethod ? all : outside).add(word);
            }
        }
        List<String> lines = new ArrayList<>();
        lines.add(String.join(", ", all) + ": all of it");
        lines.addAll(blind);
        outside.forEach(word -> lines.add(word + ": from outside the program"));
        return lines;
    }

    private Renderer.Inspection inspect(Scene scene, RenderSettings settings) {
        try {
            return Renderer.inspect(scene, settings);
        } catch (InvalidValueException e) {
            throw options.blame(e, input);
        } catch (SceneException e) {
            throw SceneFailures.inFile(input, e);
        }
    }

    private void contents(Scene scene) {
        line("name", scene.name().isEmpty() ? "(none)" : scene.name());
        line("size", scene.width() + "x" + scene.height());
        line("camera", scene.camera().type());
        Map<String, Integer> shapes = new LinkedHashMap<>();
        Map<String, Integer> used = new LinkedHashMap<>();
        for (SceneObject object : scene.objects()) {
            count(shapes, object.shape().type());
            List<Material> materials = object.faces().isEmpty() ? List.of(object.material()) : object.faces();
            for (Material material : materials) {
                count(used, material.type());
            }
        }
        line("objects", counts(shapes));
        meshes(scene);
        Map<String, Integer> lights = new LinkedHashMap<>();
        for (Light light : scene.lights()) {
            count(lights, light.type());
        }
        line("lights", counts(lights));
        Map<String, Integer> textures = new LinkedHashMap<>();
        for (Texture texture : scene.textures().values()) {
            count(textures, kind(texture));
        }
        line("named textures", counts(textures));
        Map<String, Integer> named = new LinkedHashMap<>();
        for (Material material : scene.materials().values()) {
            count(named, material.type());
        }
        line("named materials", counts(named));
        line("surfaces", counts(used));
    }

    /** Prints the contents of meshes; each counts once, however often it is placed. */
    private void meshes(Scene scene) {
        List<TriangleMesh> meshes = scene.meshes();
        if (meshes.isEmpty()) {
            return;
        }
        long instances =
                scene.objects().stream().filter(o -> o.shape() instanceof Mesh).count();
        long triangles = 0;
        long dropped = 0;
        long bytes = 0;
        int open = 0;
        for (TriangleMesh mesh : meshes) {
            triangles += mesh.triangles();
            dropped += mesh.dropped();
            bytes += mesh.bytes() + TriangleTree.bytesOf(mesh);
            open += mesh.isClosed() ? 0 : 1;
        }
        line(
                "meshes",
                String.format(
                        Locale.ROOT,
                        "%d of %d triangles, placed %d times; %.1f MiB, %.1f bytes a triangle with its hierarchy",
                        meshes.size(),
                        triangles,
                        instances,
                        bytes / MEBI,
                        bytes / (double) triangles));
        line("", dropped + " triangles without an area left out; " + open + " meshes have open edges");
    }

    private static String kind(Texture texture) {
        if (texture instanceof Texture.File) {
            return "file";
        }
        return texture instanceof Texture.Checker ? "checker" : "solid";
    }

    private static void count(Map<String, Integer> counts, String kind) {
        counts.merge(kind, 1, Integer::sum);
    }

    /** The sum, and in brackets what it is made of. */
    private static String counts(Map<String, Integer> counts) {
        int sum = 0;
        StringBuilder parts = new StringBuilder();
        for (Map.Entry<String, Integer> e : counts.entrySet()) {
            sum += e.getValue();
            parts.append(parts.isEmpty() ? "" : ", ")
                    .append(e.getValue())
                    .append(' ')
                    .append(e.getKey());
        }
        return sum == 0 ? "0" : sum + " (" + parts + ")";
    }

    private void list(String label, List<String> items) {
        if (items.isEmpty()) {
            line(label, "(nothing)");
        }
        for (int i = 0; i < items.size(); i++) {
            line(i == 0 ? label : "", items.get(i));
        }
    }

    private void line(String label, String value) {
        String name = label.isEmpty() ? "" : label + ":";
        terminal.show(Plain.line(String.format(Locale.ROOT, "%-18s%s", name, value), LONGEST_LINE));
    }
}
