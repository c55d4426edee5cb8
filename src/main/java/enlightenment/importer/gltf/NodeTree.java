package enlightenment.importer.gltf;

import enlightenment.importer.support.Affine;
import enlightenment.math.Vec3;
import java.io.IOException;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;

/** The nodes of the scene that is shown, with their maps to its coordinates. */
final class NodeTree {
    /** A node's own place: scaled, turned and moved. */
    record Placing(double[] translation, double[] rotation, double[] scale) {
        Affine affine() {
            return Affine.translate(translation[0], translation[1], translation[2])
                    .after(NodeTree.rotation(rotation))
                    .after(Affine.scale(scale[0], scale[1], scale[2]));
        }
    }

    private final GltfElement document;
    private final int count;
    private final int[] parents;
    private final NodeMotions motions;
    private final Affine[] locals;
    private final boolean[] moves;
    private final Affine[] toScene;
    private final List<Integer> order = new ArrayList<>();

    /** The nodes at the time of frame 0. */
    NodeTree(GltfElement document, NodeMotions motions) throws IOException {
        this.document = document;
        this.motions = motions;
        count = document.size("nodes");
        parents = new int[count];
        Arrays.fill(parents, -1);
        toScene = new Affine[count];
        locals = new Affine[count];
        moves = new boolean[count];
        for (int root : roots()) {
            visit(root);
        }
    }

    /** The nodes of the scene: parents before their children, else in the order of the file. */
    List<Integer> nodes() {
        return order;
    }

    GltfElement node(int index) throws IOException {
        return document.item("nodes", index);
    }

    /** The map from a node's coordinates to those of the scene; null for a node that is not in it. */
    Affine toScene(int node) {
        return toScene[node];
    }

    /** The map from a node's coordinates to those of its parent; null for a node that is not in the scene. */
    Affine local(int node) {
        return locals[node];
    }

    /** Whether a node, or one that it lies in, moves. */
    boolean moves(int node) {
        return moves[node];
    }

    /** The node that a node is a child of, or -1. */
    int parent(int node) {
        return parents[node];
    }

    private int[] roots() throws IOException {
        int scenes = document.size("scenes");
        if (scenes > 0) {
            return document.item("scenes", document.index("scene", scenes).orElse(0))
                    .indices("nodes", count);
        }
        boolean[] isChild = new boolean[count];
        for (GltfElement node : document.items("nodes")) {
            for (int child : node.indices("children", count)) {
                isChild[child] = true;
            }
        }
        int[] roots = new int[count];
        int n = 0;
        for (int i = 0; i < count; i++) {
            if (!isChild[i]) {
                roots[n++] = i;
            }
        }
        return Arrays.copyOf(roots, n);
    }

    private void visit(int root) throws IOException {
        Deque<Integer> open = new ArrayDeque<>();
        open.push(root);
        while (!open.isEmpty()) {
            int index = open.pop();
            GltfElement node = node(index);
            if (toScene[index] != null) {
                throw node.failure("is in the scene twice: a node has one parent, and no way leads from it to itself");
            }
            Affine local = local(index, node);
            locals[index] = local;
            moves[index] = motions.of(index).isPresent() || parents[index] >= 0 && moves[parents[index]];
            toScene[index] = parents[index] < 0 ? local : toScene[parents[index]].after(local);
            order.add(index);
            int[] children = node.indices("children", count);
            for (int i = children.length - 1; i >= 0; i--) {
                if (toScene[children[i]] == null) {
                    parents[children[i]] = index;
                }
                open.push(children[i]);
            }
        }
    }

    private Affine local(int index, GltfElement node) throws IOException {
        if (motions.of(index).isPresent()) {
            return motions.of(index).get().at(0).affine();
        }
        if (!node.has("matrix")) {
            return placing(node).affine();
        }
        double[] columns = node.numbers("matrix", new double[16]);
        try {
            return ofColumns(columns);
        } catch (IllegalArgumentException e) {
            throw node.failure(e.getMessage() + "; glTF writes it column by column");
        }
    }

    /**
     * The map of the 16 numbers of a matrix, column by column.
     *
     * @throws IllegalArgumentException as {@link Affine#ofRows}
     */
    static Affine ofColumns(double[] columns) {
        double[] rows = new double[16];
        for (int i = 0; i < 16; i++) {
            rows[4 * (i % 4) + i / 4] = columns[i];
        }
        return Affine.ofRows(rows);
    }

    /** The place of a node without a matrix. */
    static Placing placing(GltfElement node) throws IOException {
        return new Placing(
                node.numbers("translation", 0, 0, 0),
                node.numbers("rotation", 0, 0, 0, 1),
                node.numbers("scale", 1, 1, 1));
    }

    /** The rotation of a quaternion x, y, z, w of any length; that of length 0 turns nothing. */
    static Affine rotation(double[] q) {
        double n = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
        if (!(n > 0)) {
            return Affine.IDENTITY;
        }
        double s = 2 / n;
        double x = q[0];
        double y = q[1];
        double z = q[2];
        double w = q[3];
        return new Affine(
                new Vec3(1 - s * (y * y + z * z), s * (x * y - z * w), s * (x * z + y * w)),
                new Vec3(s * (x * y + z * w), 1 - s * (x * x + z * z), s * (y * z - x * w)),
                new Vec3(s * (x * z - y * w), s * (y * z + x * w), 1 - s * (x * x + y * y)),
                new Vec3(0, 0, 0));
    }
}
