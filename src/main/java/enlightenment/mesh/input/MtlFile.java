package enlightenment.mesh.input;

import enlightenment.math.Vec3;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;

/**
 * Reads the material libraries of OBJ files (MTL). What they say is passed on as it is; what they do not say is empty.
 *
 * <p>All methods may be called by several threads at once.
 */
public final class MtlFile {
    private static final int MOST_MATERIALS = 1 << 16;

    /** By option of a map: the number of its arguments, or the most that are numbers, as a negative number. */
    private static final Map<String, Integer> OPTIONS = Map.ofEntries(
            Map.entry("-blendu", 1),
            Map.entry("-blendv", 1),
            Map.entry("-bm", 1),
            Map.entry("-boost", 1),
            Map.entry("-cc", 1),
            Map.entry("-clamp", 1),
            Map.entry("-colorspace", 1),
            Map.entry("-imfchan", 1),
            Map.entry("-texres", 1),
            Map.entry("-mm", 2),
            Map.entry("-o", -3),
            Map.entry("-s", -3),
            Map.entry("-t", -3));

    private final List<Material> materials = new ArrayList<>();
    private Values values;

    /**
     * A material.
     *
     * @param kd diffuse reflectance
     * @param ks specular reflectance
     * @param ke emission
     * @param ns exponent of the highlight
     * @param ni index of refraction
     * @param d opacity, 1 is opaque; from {@code Tr} as 1 − Tr
     * @param illum number of the illumination model
     * @param mapKd path of the texture of kd as it is written, without options; so are the others
     * @param mapKe path of the texture of ke
     * @param mapD path of the texture of d
     */
    public record Material(
            String name,
            Optional<Vec3> kd,
            Optional<Vec3> ks,
            Optional<Vec3> ke,
            OptionalDouble ns,
            OptionalDouble ni,
            OptionalDouble d,
            OptionalInt illum,
            Optional<String> mapKd,
            Optional<String> mapKe,
            Optional<String> mapD) {}

    /** What was read of a material so far; null where nothing was. */
    private static final class Values {
        final String name;
        Vec3 kd;
        Vec3 ks;
        Vec3 ke;
        OptionalDouble ns = OptionalDouble.empty();
        OptionalDouble ni = OptionalDouble.empty();
        OptionalDouble d = OptionalDouble.empty();
        OptionalInt illum = OptionalInt.empty();
        String mapKd;
        String mapKe;
        String mapD;

        Values(String name) {
            this.name = name;
        }

        Material material() {
            return new Material(
                    name,
                    Optional.ofNullable(kd),
                    Optional.ofNullable(ks),
                    Optional.ofNullable(ke),
                    ns,
                    ni,
                    d,
                    illum,
                    Optional.ofNullable(mapKd),
                    Optional.ofNullable(mapKe),
                    Optional.ofNullable(mapD));
        }
    }

    private MtlFile() {}

    /**
     * Reads the materials of a file, in its order.
     *
     * @throws IOException naming file and line for what is no MTL: values before the first material, or that are no numbers
     */
    public static List<Material> read(Path file) throws IOException {
        return read(MeshSource.of(file));
    }

    public static List<Material> read(MeshSource source) throws IOException {
        MtlFile file = new MtlFile();
        try (InputStream stream = source.open(0)) {
            TextInput in = new TextInput(source, stream, 1);
            while (!in.atEnd()) {
                in.blanks();
                file.readLine(in);
                in.nextLine();
            }
        }
        file.endMaterial();
        return List.copyOf(file.materials);
    }

    private void readLine(TextInput in) throws IOException {
        if (in.here() == '#') {
            return;
        }
        String word = in.word();
        in.blanks();
        if (word.equals("newmtl")) {
            endMaterial();
            values = new Values(in.rest());
            if (materials.size() >= MOST_MATERIALS) {
                throw in.failure("has a material after " + MOST_MATERIALS + " others");
            }
            return;
        }
        boolean isKnown =
                switch (word) {
                    case "Kd", "Ks", "Ke", "Ns", "Ni", "d", "Tr", "illum", "map_Kd", "map_Ke", "map_d" -> true;
                    default -> false;
                };
        if (isKnown && values == null) {
            throw in.failure("has " + word + " before the first newmtl");
        }
        if (isKnown) {
            readValue(word, in);
        }
    }

    private void endMaterial() {
        if (values != null) {
            materials.add(values.material());
        }
    }

    private void readValue(String word, TextInput in) throws IOException {
        switch (word) {
            case "Kd" -> values.kd = color(in, values.kd);
            case "Ks" -> values.ks = color(in, values.ks);
            case "Ke" -> values.ke = color(in, values.ke);
            case "Ns" -> values.ns = OptionalDouble.of(in.number());
            case "Ni" -> values.ni = OptionalDouble.of(in.number());
            case "d" -> values.d = OptionalDouble.of(opacity(in));
            case "Tr" -> values.d = OptionalDouble.of(1 - in.number());
            case "illum" -> values.illum = OptionalInt.of(model(in));
            case "map_Kd" -> values.mapKd = path(in);
            case "map_Ke" -> values.mapKe = path(in);
            default -> values.mapD = path(in);
        }
    }

    /** One number stands for three. Spectra and CIE XYZ leave the colour as it was. */
    private static Vec3 color(TextInput in, Vec3 before) throws IOException {
        if (in.here() == 's' || in.here() == 'x') {
            return before;
        }
        double r = in.number();
        in.blanks();
        if (in.atLineEnd() || in.here() == '#') {
            return new Vec3(r, r, r);
        }
        double g = in.number();
        in.blanks();
        return new Vec3(r, g, in.number());
    }

    /** The opacity; that of {@code -halo} is the least. */
    private static double opacity(TextInput in) throws IOException {
        if (in.here() == '-') {
            String option = in.word();
            if (!option.equals("-halo")) {
                throw in.failure("has an opacity that is no number of at least 0");
            }
            in.blanks();
        }
        return in.number();
    }

    private static int model(TextInput in) throws IOException {
        long model = in.integer();
        in.endWord();
        if (model < 0 || model > 1000) {
            throw in.failure("has the illumination model " + model + "; there are 0 to 10");
        }
        return (int) model;
    }

    /** The path behind the options, null if there is none; it may have blanks. */
    private static String path(TextInput in) throws IOException {
        String rest = in.rest();
        while (rest.startsWith("-")) {
            String option = rest.split("[ \t]", 2)[0];
            Integer arguments = OPTIONS.get(option);
            if (arguments == null) {
                break;
            }
            rest = rest.substring(option.length()).stripLeading();
            for (int i = 0; i < Math.abs(arguments); i++) {
                String argument = rest.split("[ \t]", 2)[0];
                if (arguments > 0 || argument.matches("[-+]?[0-9.]+(?:[eE][-+]?[0-9]+)?")) {
                    rest = rest.substring(argument.length()).stripLeading();
                }
            }
        }
        return rest.isEmpty() ? null : rest;
    }
}
