package enlightenment.shading;

import enlightenment.numeric.MedianCut;
import java.util.Arrays;
import java.util.List;
import java.util.function.Consumer;

/** Beams by where they pass: a hierarchy of boxes, each node cut in halves across the longest side of its starts. Immutable. */
final class BeamTree {
    /** A group has at most so many beams, and more than half as many. */
    private static final int GROUP = 16;

    /** A beam is spread as far as this one of those in its group, by distance, is away: the first is the beam itself. */
    private static final int NEIGHBOUR = 8;

    private final MediumBeam[] beams;
    private final int levels;

    /** By node, the root first and its halves at 2 i + 1 and 2 i + 2: the first of its beams, and the first after them. */
    private final int[] from;

    private final int[] to;

    /** By node: least x, y, z, greatest x, y, z. */
    private final double[][] boxes;

    /** @param paths how many paths the beams are of */
    BeamTree(List<MediumBeam> all, int paths) {
        beams = all.toArray(new MediumBeam[0]);
        int deep = 0;
        while (beams.length > (long) GROUP << deep) {
            deep++;
        }
        levels = deep;
        int nodes = (2 << levels) - 1;
        from = new int[nodes];
        to = new int[nodes];
        boxes = new double[nodes][];
        build(0, 0, beams.length, paths);
    }

    private void build(int node, int first, int end, int paths) {
        from[node] = first;
        to[node] = end;
        if (isLeaf(node)) {
            spread(first, end, paths);
            boxes[node] = empty();
            for (int k = first; k < end; k++) {
                include(boxes[node], beams[k]);
            }
            return;
        }
        int axis = MedianCut.longestSide(first, end, (k, side) -> start(beams[k], side));
        Arrays.sort(beams, first, end, (a, b) -> Double.compare(start(a, axis), start(b, axis)));
        int middle = first + (end - first) / 2;
        build(2 * node + 1, first, middle, paths);
        build(2 * node + 2, middle, end, paths);
        double[] box = boxes[2 * node + 1].clone();
        double[] other = boxes[2 * node + 2];
        for (int axisOf = 0; axisOf < 3; axisOf++) {
            box[axisOf] = Math.min(box[axisOf], other[axisOf]);
            box[3 + axisOf] = Math.max(box[3 + axisOf], other[3 + axisOf]);
        }
        boxes[node] = box;
    }

    private boolean isLeaf(int node) {
        return node >= (1 << levels) - 1;
    }

    private static double start(MediumBeam beam, int axis) {
        return axis == 0 ? beam.x : axis == 1 ? beam.y : beam.z;
    }

    /** Spreads the beams of a group by how far they are apart: any width keeps their power. */
    private void spread(int first, int end, int paths) {
        double[] squares = new double[end - first];
        for (int k = first; k < end; k++) {
            MediumBeam beam = beams[k];
            for (int j = first; j < end; j++) {
                double x = beams[j].x - beam.x;
                double y = beams[j].y - beam.y;
                double z = beams[j].z - beam.z;
                squares[j - first] = x * x + y * y + z * z;
            }
            Arrays.sort(squares);
            double radius = Math.sqrt(squares[Math.min(NEIGHBOUR, squares.length) - 1]);
            beam.spreadBy(radius > 0 ? radius : beam.length, paths);
        }
    }

    private static double[] empty() {
        double[] box = new double[6];
        Arrays.fill(box, 0, 3, Double.POSITIVE_INFINITY);
        Arrays.fill(box, 3, 6, Double.NEGATIVE_INFINITY);
        return box;
    }

    private static void include(double[] box, MediumBeam beam) {
        double reach = beam.reach();
        double wide = beam.radius();
        double[] at = {beam.x, beam.y, beam.z};
        double[] along = {beam.dx, beam.dy, beam.dz};
        for (int axis = 0; axis < 3; axis++) {
            double end = at[axis] + reach * along[axis];
            box[axis] = Math.min(box[axis], Math.min(at[axis], end) - wide);
            box[3 + axis] = Math.max(box[3 + axis], Math.max(at[axis], end) + wide);
        }
    }

    /** Shows all beams that may pass a point, in a fixed order. */
    void at(double x, double y, double z, Consumer<MediumBeam> visitor) {
        visit(0, x, y, z, visitor);
    }

    private void visit(int node, double x, double y, double z, Consumer<MediumBeam> visitor) {
        double[] box = boxes[node];
        boolean isInside = x >= box[0] && x <= box[3] && y >= box[1] && y <= box[4] && z >= box[2] && z <= box[5];
        if (!isInside) {
            return;
        }
        if (!isLeaf(node)) {
            visit(2 * node + 1, x, y, z, visitor);
            visit(2 * node + 2, x, y, z, visitor);
            return;
        }
        for (int k = from[node]; k < to[node]; k++) {
            visitor.accept(beams[k]);
        }
    }
}
