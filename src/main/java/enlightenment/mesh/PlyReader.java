package enlightenment.mesh;

import enlightenment.mesh.PlyHeader.Element;
import enlightenment.mesh.PlyHeader.Property;
import enlightenment.mesh.data.VertexArrays;
import enlightenment.mesh.input.BinaryInput;
import enlightenment.mesh.input.MeshSource;
import enlightenment.mesh.input.TextInput;
import enlightenment.text.Plain;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;

/**
 * Reads PLY files: ascii and both binary forms, elements in any order. Elements and properties that a mesh has no use for are skipped.
 * Polygons become fans. Numbers of the type {@code float} are floats in the ascii form too, correctly rounded.
 */
final class PlyReader {
    /** The properties of a vertex: coordinates, normal, and the names that texture coordinates have. */
    private static final String[] POSITION = {"x", "y", "z"};

    private static final String[] NORMAL = {"nx", "ny", "nz"};
    private static final String[][] UV = {{"u", "v"}, {"s", "t"}, {"texture_u", "texture_v"}, {"texture_s", "texture_t"}
    };

    private final MeshSource source;
    private final PlyHeader header;
    private final long maxTriangles;

    /** The element and the number of its record that is being read. */
    private String element = "header";

    private long record;

    private float[] positions;
    private double[] longPositions;
    private float[] normals;
    private float[] uv;
    private Ints indices;
    private int vertices;

    PlyReader(MeshSource source, long maxTriangles) throws IOException {
        this.source = source;
        this.maxTriangles = maxTriangles;
        header = new PlyHeader(source);
    }

    /** Whether the header names colours of vertices. */
    boolean hasColors() {
        return header.elements.stream().anyMatch(e -> e.name().equals("vertex") && e.find("red", false) >= 0);
    }

    TriangleMesh mesh() throws IOException {
        vertices = count("vertex");
        int faces = count("face");
        if (vertices == 0 || faces == 0) {
            throw source.failure("has " + vertices + " vertices and " + faces
                    + " faces; a mesh needs some of both, elements vertex and face");
        }
        try (InputStream in = source.open(header.length())) {
            PlyBody body = body(in);
            for (Element e : header.elements) {
                read(e, body);
            }
        }
        int[] corners = indices.toArray();
        indices = null; // its array is a longer one, and no longer needed
        VertexArrays vertices = longPositions == null
                ? new VertexArrays(positions, null, normals, uv)
                : VertexArrays.of(longPositions, normals, uv);
        return new TriangleMesh(vertices, corners);
    }

    private int count(String name) throws IOException {
        for (Element e : header.elements) {
            if (e.name().equals(name)) {
                if (e.count() > Floats.LONGEST / 3) {
                    throw source.failure(
                            "has " + e.count() + " elements " + name + "; there may be at most " + Floats.LONGEST / 3);
                }
                return (int) e.count();
            }
        }
        return 0;
    }

    private PlyBody body(InputStream in) throws IOException {
        long size = source.size - header.length();
        return switch (header.form()) {
            case ASCII -> PlyBody.ascii(new TextInput(source, in, header.lines() + 1L), size, this::place);
            case LITTLE_ENDIAN ->
                PlyBody.binary(new BinaryInput(source, in, size, ByteOrder.LITTLE_ENDIAN, this::place));
            case BIG_ENDIAN -> PlyBody.binary(new BinaryInput(source, in, size, ByteOrder.BIG_ENDIAN, this::place));
        };
    }

    private String place() {
        return element + " " + record;
    }

    private void read(Element e, PlyBody body) throws IOException {
        element = Plain.excerpt(e.name());
        record = 0;
        long least = 0;
        for (Property p : e.properties()) {
            least += body.leastBytes(p.count().orElse(p.type()));
        }
        if (least > 0 && e.count() > body.left() / least) {
            throw source.failure("has " + e.count() + " elements " + Plain.quoted(e.name()) + " of at least " + least
                    + " bytes by its header, which is more than the file holds");
        }
        switch (e.name()) {
            case "vertex" -> readVertices(e, body);
            case "face" -> readFaces(e, body);
            default -> skip(e, body);
        }
    }

    private void skip(Element e, PlyBody body) throws IOException {
        long records = e.properties().isEmpty() ? 0 : e.count();
        for (record = 0; record < records; record++) {
            for (Property p : e.properties()) {
                body.skip(p.type(), p.count().isEmpty() ? 1 : length(p, body));
            }
        }
    }

    /** The length of a list, all of which the file holds. */
    private long length(Property p, PlyBody body) throws IOException {
        long n = body.integer(p.count().orElseThrow());
        if (n < 0 || n > body.left() / body.leastBytes(p.type())) {
            throw body.failure("has a list of " + n + " numbers, which is "
                    + (n < 0 ? "less than none" : "more than the file holds"));
        }
        return n;
    }

    private void readVertices(Element e, PlyBody body) throws IOException {
        header.checkNames(e);
        int[] slots = new int[e.properties().size()];
        Arrays.fill(slots, -1);
        if (!find(e, POSITION, 0, slots)) {
            throw source.failure("has vertices without properties x, y and z");
        }
        boolean isOfFloats = true;
        for (int i = 0; i < slots.length; i++) {
            isOfFloats &= slots[i] < 0 || e.properties().get(i).type().isOfFloats();
        }
        positions = isOfFloats ? new float[3 * vertices] : null;
        longPositions = isOfFloats ? null : new double[3 * vertices];
        normals = find(e, NORMAL, 3, slots) ? new float[3 * vertices] : null;
        for (int i = 0; i < UV.length && uv == null; i++) {
            uv = find(e, UV[i], 6, slots) ? new float[2 * vertices] : null;
        }
        double[] values = new double[8];
        for (int v = 0; v < vertices; v++) {
            record = v;
            for (int i = 0; i < slots.length; i++) {
                Property p = e.properties().get(i);
                if (slots[i] >= 0) {
                    values[slots[i]] = body.number(p.type());
                } else {
                    body.skip(p.type(), p.count().isEmpty() ? 1 : length(p, body));
                }
            }
            store(v, values);
        }
    }

    /** Gives properties their slots if the element has all of them. */
    private static boolean find(Element e, String[] names, int first, int[] slots) {
        for (String name : names) {
            if (e.find(name, false) < 0) {
                return false;
            }
        }
        for (int i = 0; i < names.length; i++) {
            slots[e.find(names[i], false)] = first + i;
        }
        return true;
    }

    private void store(int v, double[] values) {
        for (int axis = 0; axis < 3; axis++) {
            if (positions != null) {
                positions[3 * v + axis] = (float) values[axis];
            } else {
                longPositions[3 * v + axis] = values[axis];
            }
            if (normals != null) {
                normals[3 * v + axis] = (float) values[3 + axis];
            }
        }
        if (uv != null) {
            uv[2 * v] = (float) values[6];
            uv[2 * v + 1] = (float) values[7];
        }
    }

    private void readFaces(Element e, PlyBody body) throws IOException {
        header.checkNames(e);
        int list = Math.max(e.find("vertex_indices", true), e.find("vertex_index", true));
        if (list < 0 || !e.properties().get(list).type().isInteger()) {
            throw source.failure("has faces without a list vertex_indices of integers");
        }
        indices = new Ints((int) Math.min(3 * e.count(), 3 * Math.min(maxTriangles, Floats.LONGEST / 3)));
        for (record = 0; record < e.count(); record++) {
            readFace(e.properties(), list, body);
        }
    }

    private void readFace(List<Property> properties, int list, PlyBody body) throws IOException {
        for (int i = 0; i < properties.size(); i++) {
            Property p = properties.get(i);
            if (i == list) {
                readPolygon(p, body);
            } else {
                body.skip(p.type(), p.count().isEmpty() ? 1 : length(p, body));
            }
        }
    }

    private void readPolygon(Property p, PlyBody body) throws IOException {
        long n = length(p, body);
        if (n > MeshMaking.MOST_CORNERS) {
            throw body.failure("has " + n + " corners; there may be at most " + MeshMaking.MOST_CORNERS);
        }
        if (indices.size() / 3 + Math.max(0, n - 2) > maxTriangles) {
            throw body.failure("exceeds the limit of " + maxTriangles + " triangles");
        }
        int first = 0;
        int last = 0;
        for (int k = 0; k < n; k++) {
            int v = vertex(body.integer(p.type()), body);
            if (k == 0) {
                first = v;
            } else if (k > 1) {
                indices.add(first);
                indices.add(last);
                indices.add(v);
            }
            last = v;
        }
    }

    private int vertex(long v, PlyBody body) throws IOException {
        if (v < 0 || v >= vertices) {
            throw body.failure("has the vertex " + v + "; there are " + vertices + " from 0");
        }
        return (int) v;
    }
}
