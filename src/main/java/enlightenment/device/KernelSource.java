package enlightenment.device;

import enlightenment.primitive.FlatForm;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** The code that devices run, in OpenCL C 1.2. */
public final class KernelSource {
    private static final List<String> PARTS = List.of(
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
            "shafts.cl",
            "materials.cl",
            "lights.cl",
            "classic.cl");

    private KernelSource() {}

    /** All of it, with the places of a {@link DeviceScene}'s numbers. */
    public static String text() {
        StringBuilder text = new StringBuilder();
        for (DeviceScene.Int slot : DeviceScene.Int.values()) {
            define(text, slot.name(), slot.ordinal());
        }
        for (DeviceScene.Number slot : DeviceScene.Number.values()) {
            define(text, slot.name(), slot.place());
        }
        for (FlatForm.Kind kind : FlatForm.Kind.values()) {
            define(text, kind.name(), kind.ordinal());
        }
        for (String part : PARTS) {
            text.append(read(part)).append('\n');
        }
        return text.toString();
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
