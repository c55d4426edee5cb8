package enlightenment.mesh;

import enlightenment.mesh.input.MeshSource;
import enlightenment.mesh.input.TextInput;
import enlightenment.text.Plain;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;

/**
 * Reads OBJ files: one part for each material, in the order in which faces first use them. Numbers are rounded correctly to floats. Polygons
 * become fans. Lines, points, curves, groups and smoothing groups are skipped. A face may name vertices that come after it.
 */
final class ObjReader {
    private static final int MOST_MATERIALS = 1 << 16;
    private static final int V = 'v';
    private static final int F = 'f';
    private static final int VT = 'v' << 8 | 't';
    private static final int VN = 'v' << 8 | 'n';

    /** One of the three lists that corners point into. */
    private static final class Attribute {
        final String name;
        final int each;
        final Floats values = new Floats(12);

        /** The largest index of a corner, counted from 0, and the first line that has it. */
        private int largest = -1;

        private long line;

        Attribute(String name, int each) {
            this.name = name;
            this.each = each;
        }

        int count() {
            return values.size() / each;
        }

        /** The index, counted from 0, of a number in a face: it counts from 1, or from -1 backwards. */
        int index(long number, TextInput in) throws IOException {
            long i = number < 0 ? count() + number : number - 1;
            if (number == 0 || i < 0 || i > Floats.LONGEST) {
                throw in.failure("has the " + name + " " + number + "; there are " + count() + " so far, from 1");
            }
            if (i > largest) {
                largest = (int) i;
                line = in.line();
            }
            return (int) i;
        }

        void checkLargest(TextInput in) throws IOException {
            if (largest >= count()) {
                throw in.failureAt(
                        line, "has the " + name + " " + (largest + 1L) + "; there are " + count() + ", from 1");
            }
        }
    }

    private final MeshSource source;
    private final long maxTriangles;
    private final Attribute positions = new Attribute("vertex", 3);
    private final Attribute uv = new Attribute("texture vertex", 2);
    private final Attribute normals = new Attribute("normal", 3);

    /** Whether the first vertex has red, green and blue after its coordinates. */
    private boolean hasColors;

    private final Map<String, ObjPart> parts = new LinkedHashMap<>();
    private final Set<String> libraries = new LinkedHashSet<>();
    private String material = "";

    /** The part of the material; null until a face uses it. */
    private ObjPart part;

    private long triangles;

    private ObjReader(MeshSource source, long maxTriangles) {
        this.source = source;
        this.maxTriangles = maxTriangles;
    }

    static MeshFiles.Contents read(MeshSource source, long maxTriangles) throws IOException {
        return new ObjReader(source, maxTriangles).file();
    }

    private MeshFiles.Contents file() throws IOException {
        try (InputStream stream = source.open(0)) {
            TextInput in = new TextInput(source, stream, 1);
            while (!in.atEnd()) {
                in.blanks();
                readLine(in);
                in.nextLine();
            }
            positions.checkLargest(in);
            uv.checkLargest(in);
            normals.checkLargest(in);
        }
        List<MeshFiles.Part> read = new ArrayList<>();
        for (ObjPart p : parts.values()) {
            p.mesh(source, positions.values, uv.values, normals.values)
                    .ifPresent(mesh -> read.add(new MeshFiles.Part(p.material, mesh)));
        }
        if (read.isEmpty()) {
            throw source.failure(
                    triangles == 0
                            ? "has " + positions.count() + " vertices and no faces (f); nothing else makes a mesh"
                            : "has no triangle with an area");
        }
        return new MeshFiles.Contents(read, List.copyOf(libraries), hasColors);
    }

    private void readLine(TextInput in) throws IOException {
        switch (in.shortWord()) {
            case V -> readVertex(in);
            case VT -> readTextureVertex(in);
            case VN -> readNumbers(in, 3, normals.values);
            case F -> readFace(in);
            case 0 -> readNames(in);
            default -> {}
        }
    }

    private void readVertex(TextInput in) throws IOException {
        boolean isFirst = positions.count() == 0;
        readNumbers(in, 3, positions.values);
        if (isFirst) {
            in.blanks();
            hasColors = in.rest().matches("[^#\\s]+[ \t]+[^#\\s]+[ \t]+[^#\\s].*");
        }
    }

    private static void readNumbers(TextInput in, int count, Floats to) throws IOException {
        for (int i = 0; i < count; i++) {
            in.blanks();
            to.add(in.floatNumber());
        }
    }

    /** The second coordinate is 0 where it is missing, as for textures of one dimension. */
    private void readTextureVertex(TextInput in) throws IOException {
        readNumbers(in, 1, uv.values);
        in.blanks();
        uv.values.add(isDone(in) ? 0 : in.floatNumber());
    }

    private static boolean isDone(TextInput in) {
        return in.atLineEnd() || in.here() == '#';
    }

    private void readNames(TextInput in) throws IOException {
        if (in.atLineEnd() || in.here() == '#') {
            return;
        }
        int first = in.here();
        if (first != 'u' && first != 'm') {
            return;
        }
        String word = in.word();
        in.blanks();
        if (word.equals("usemtl")) {
            material = in.rest();
            part = parts.get(material);
        } else if (word.equals("mtllib")) {
            addLibraries(in.rest());
            if (libraries.size() > MOST_MATERIALS) {
                throw in.failure("has more than " + MOST_MATERIALS + " material libraries");
            }
        }
    }

    /** Several names if each ends with .mtl, else one, which may have blanks. */
    private void addLibraries(String rest) {
        List<String> names = List.of(rest.split("[ \t]+"));
        boolean areSeveral =
                names.stream().allMatch(n -> n.toLowerCase(Locale.ROOT).endsWith(".mtl"));
        if (!rest.isEmpty()) {
            libraries.addAll(areSeveral ? names : List.of(rest));
        }
    }

    private void readFace(TextInput in) throws IOException {
        if (part == null) {
            part = part(in);
        }
        int corners = 0;
        int first = 0;
        int last = 0;
        for (in.blanks(); !isDone(in); in.blanks()) {
            int corner = readCorner(in);
            corners++;
            if (corners > MeshMaking.MOST_CORNERS) {
                throw in.failure("has a face of more than " + MeshMaking.MOST_CORNERS + " corners");
            }
            if (corners == 1) {
                first = corner;
            } else if (corners > 2) {
                part.triangle(first, last, corner);
                triangles++;
            }
            last = corner;
        }
        if (corners < 3) {
            throw in.failure("has a face of " + corners + " corners; at least 3 are expected");
        }
        if (triangles > maxTriangles) {
            throw in.failure("exceeds the limit of " + maxTriangles + " triangles");
        }
    }

    private ObjPart part(TextInput in) throws IOException {
        if (parts.size() >= MOST_MATERIALS) {
            throw in.failure("has the material " + Plain.quoted(material) + " after " + MOST_MATERIALS + " others");
        }
        return parts.computeIfAbsent(material, ObjPart::new);
    }

    /** One of {@code a}, {@code a/b}, {@code a//c} and {@code a/b/c}. */
    private int readCorner(TextInput in) throws IOException {
        int a = positions.index(in.integer(), in);
        int b = -1;
        int c = -1;
        if (in.here() == '/') {
            in.step();
            if (in.here() != '/') {
                b = uv.index(in.integer(), in);
            }
            if (in.here() == '/') {
                in.step();
                c = normals.index(in.integer(), in);
            }
        }
        in.endWord();
        return part.vertex(a, b, c);
    }
}
