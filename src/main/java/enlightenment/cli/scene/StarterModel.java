package enlightenment.cli.scene;

import enlightenment.cli.terminal.CliException;
import enlightenment.file.FileFailure;
import enlightenment.frame.Bounds;
import enlightenment.math.Vec3;
import enlightenment.mesh.MeshFiles;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.math.RoundingMode;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/**
 * A mesh file as an object of a starter scene: its box, turned upright, and the transform that puts that box into its place.
 *
 * <p>Mesh files are right-handed and face +z, of STL files −y, where z points upwards; templates are left-handed and seen from −z. The transform
 * mirrors z, so that a model shows its front and its writing can be read.
 *
 * @param min lower corner of the box around all triangles, with y upwards
 * @param max its upper corner
 * @param isUpZ whether z points upwards in the file, else y; {@code min} and {@code max} are turned already
 * @param hasNormals whether all parts of the file have normals of vertices
 */
record StarterModel(Vec3 min, Vec3 max, boolean isUpZ, boolean hasNormals) {
    /** A gap of this share of the place's height keeps faces of the model out of the plane that it stands on. */
    private static final double GAP = 1.0 / 1024;

    /** Offsets are rounded to a tenth to this power of the box's size: to much less than the gap. */
    private static final int DIGITS = 6;

    /**
     * Reads a PLY, OBJ, STL or {@code .serialized} file.
     *
     * @throws CliException if it cannot be read
     */
    static StarterModel read(Path file) {
        try {
            return of(
                    MeshFiles.read(file, MeshFiles.MAX_TRIANGLES),
                    file.toString().toLowerCase(Locale.ROOT).endsWith(".stl"));
        } catch (IOException e) {
            throw CliException.wrongUsage(FileFailure.described(e));
        }
    }

    private static StarterModel of(List<MeshFiles.Part> parts, boolean isUpZ) {
        Bounds box = parts.stream()
                .map(part -> new Bounds(part.mesh().min(), part.mesh().max()))
                .reduce(Bounds::union)
                .orElseThrow();
        Vec3 min = box.min();
        Vec3 max = box.max();
        boolean hasNormals = parts.stream().allMatch(part -> part.mesh().hasNormals());
        // By -90 degrees about x, (x, y, z) becomes (x, z, -y).
        return isUpZ
                ? new StarterModel(
                        new Vec3(min.x(), min.z(), -max.y()), new Vec3(max.x(), max.z(), -min.y()), true, hasNormals)
                : new StarterModel(min, max, false, hasNormals);
    }

    /** The factor that makes the box as large as the place allows: its height, and its diagonal as seen from above. */
    private double scale(ModelPlace place) {
        Vec3 size = max.minus(min);
        return Math.min(place.height() / size.y(), 2 * place.radius() / StrictMath.hypot(size.x(), size.z()));
    }

    /**
     * The object as lines of a scene file, each with its end.
     *
     * @param file the path for the scene file, as a JSON string
     * @param indent before each line
     */
    String object(ModelPlace place, String file, String indent) {
        String factor = new BigDecimal(scale(place))
                .round(new MathContext(DIGITS, RoundingMode.DOWN))
                .toString();
        String smooth = hasNormals ? "" : ", \"normals\": \"smooth\", \"crease\": 40";
        return indent + "// The model: its box is moved over the origin, made as large as fits, and put in its place.\n"
                + indent
                + "// Mesh files are right-handed, this scene is left-handed: the factor below 0 turns that round.\n"
                + (hasNormals
                        ? ""
                        : indent
                                + "// Edges sharper than \"crease\" stay; \"normals\": \"flat\" shows each triangle.\n")
                + indent + "{ \"name\": \"model\", \"type\": \"mesh\", \"file\": " + file + smooth + ",\n"
                + indent + "  \"material\": \"" + place.material() + "\",\n"
                + indent + "  \"transform\": [\n"
                + (isUpZ ? indent + "    { \"rotate\": [-90, 0, 0] },\n" : "")
                + indent + "    { \"translate\": " + offset() + " },\n"
                + indent + "    { \"scale\": [" + factor + ", " + factor + ", -" + factor + "] },\n"
                + indent + "    { \"translate\": " + target(place) + " }\n"
                + indent + "  ] }";
    }

    /** The translation that moves the middle of the box's base to the origin. */
    private String offset() {
        Vec3 size = max.minus(min);
        double largest = Math.max(size.x(), Math.max(size.y(), size.z()));
        int scale = DIGITS - (int) Math.floor(StrictMath.log10(largest));
        return "[" + rounded(-(min.x() / 2 + max.x() / 2), scale) + ", " + rounded(-min.y(), scale) + ", "
                + rounded(-(min.z() / 2 + max.z() / 2), scale) + "]";
    }

    private static String target(ModelPlace place) {
        Vec3 foot = place.foot();
        return "[" + rounded(foot.x(), DIGITS) + ", " + rounded(foot.y() + GAP * place.height(), DIGITS) + ", "
                + rounded(foot.z(), DIGITS) + "]";
    }

    private static String rounded(double value, int scale) {
        BigDecimal decimal =
                new BigDecimal(value).setScale(scale, RoundingMode.HALF_EVEN).stripTrailingZeros();
        // Whole numbers without an exponent, unless they would be long.
        return decimal.scale() < 0 && decimal.scale() > -DIGITS ? decimal.toPlainString() : decimal.toString();
    }
}
