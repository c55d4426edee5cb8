package enlightenment.device;

import enlightenment.bsdf.FlatBsdf;
import enlightenment.primitive.FlatForm;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** The code that devices run, in OpenCL C 1.2. */
public final class KernelSource {
    private static final List<String> COMMON = List.of(
            "numbers.cl",
            "arithmetic.cl",
            "rays.cl",
            "flat.cl",
            "solids.cl",
            "axial.cl",
            "boxes.cl",
            "triangles.cl",
            "meshes.cl",
            "search.cl",
            "glass.cl",
            "materials.cl",
            "cones.cl",
            "lights.cl",
            "samples.cl");

    private static final List<String> CLASSIC = List.of("shafts.cl", "classic.cl");

    private static final List<String> PHYSICAL = List.of(
            "irradiance.cl",
            "rectangles.cl",
            "areas.cl",
            "occluders.cl",
            "picker.cl",
            "scattering.cl",
            "metals.cl",
            "coats.cl",
            "bsdfs.cl",
            "direct.cl",
            "paths.cl");

    private KernelSource() {}

    /** All of a program, with the places of a {@link DeviceScene}'s numbers. */
    public static String text(DeviceScene.Program program) {
        StringBuilder text = new StringBuilder();
        define(text, DeviceScene.Int.values());
        for (DeviceScene.Number slot : DeviceScene.Number.values()) {
            define(text, slot.name(), slot.place());
        }
        define(text, FlatForm.Kind.values());
        define(text, FlatBsdf.Kind.values());
        define(text, DeviceScene.Lookup.values());
        define(text, DeviceScene.Form.values());
        define(text, "ARITHMETIC_RESULTS", Arithmetic.RESULTS);
        for (String part : COMMON) {
            text.append(read(part)).append('\n');
        }
        for (String part : program == DeviceScene.Program.CLASSIC ? CLASSIC : PHYSICAL) {
            text.append(read(part)).append('\n');
        }
        text.append(read("shade.cl"));
        return text.toString();
    }

    private static void define(StringBuilder text, Enum<?>[] names) {
        for (Enum<?> name : names) {
            define(text, name.name(), name.ordinal());
        }
    }

    private static void define(StringBuilder text, String name, int value) {
        text.append("#define ").append(name).append(' ').append(value).append('\n');
    }

    private static String read(String part) {
        try (InputStream in = KernelSource.class.getResourceAsStream(part)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException("cannot read " + part + " of the program's own", e);
        }
    }
}
