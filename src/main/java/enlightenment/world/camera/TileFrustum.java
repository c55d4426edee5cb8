package enlightenment.world.camera;

import enlightenment.frame.Bounds;
import enlightenment.numeric.Scale;
import enlightenment.primitive.Ray;
import java.util.Arrays;

/**
 * The frustum of the camera rays of one tile: four planes through the rays at its corners.
 *
 * <p>No ray of the tile meets a primitive whose box lies completely outside one of the planes. The test is conservative: its
 * margin covers all roundings. Of cameras with a lens and of panoramas, whose rays no such planes bound, it reaches everything.
 *
 * <p>A reusable work object, written with arrays and loops: it is set for every tile, and small code is compiled quickly
 * (docs/notes/benchmarks.md, "start-up").
 */
public final class TileFrustum {
    private static final double PLANE_ERROR = Scale.gamma(64);
    private static final int PLANES = 4;

    /** Origins and directions of the rays at the four corners, then of the middle ray. */
    private final double[] origins = new double[3 * (PLANES + 1)];

    private final double[] directions = new double[3 * (PLANES + 1)];

    /** Per plane: its inward normal, and a bound of its roundings per unit of distance. */
    private final double[] normals = new double[3 * PLANES];

    private final double[] errors = new double[PLANES];

    private final Ray ray = new Ray();

    /** Sets the frustum of the rays through (x0..x1, y0..y1), 0..1 from the picture's upper left corner. */
    public void set(CompiledCamera camera, double x0, double y0, double x1, double y1) {
        for (int i = 0; i <= PLANES; i++) {
            double x = i == PLANES ? (x0 + x1) / 2 : i == 1 || i == 2 ? x1 : x0;
            double y = i == PLANES ? (y0 + y1) / 2 : i >= 2 ? y1 : y0;
            camera.ray(x, y, ray);
            origins[3 * i] = ray.ox;
            origins[3 * i + 1] = ray.oy;
            origins[3 * i + 2] = ray.oz;
            directions[3 * i] = ray.dx;
            directions[3 * i + 1] = ray.dy;
            directions[3 * i + 2] = ray.dz;
        }
        if (!camera.isPinholeOrParallel()) {
            // No planes: nothing lies beyond normals of length 0.
            Arrays.fill(normals, 0);
            Arrays.fill(errors, 0);
            return;
        }
        for (int i = 0; i < PLANES; i++) {
            setPlane(i, (i + 1) % PLANES);
        }
    }

    /** The plane that contains corner ray i and a point of corner ray j. */
    private void setPlane(int i, int j) {
        double inside = 0;
        double size = 0;
        double length = 0;
        for (int c = 0; c < 3; c++) {
            int a = (c + 1) % 3;
            int b = (c + 2) % 3;
            double n = directions[3 * i + a] * across(i, j, b) - directions[3 * i + b] * across(i, j, a);
            normals[3 * i + c] = n;
            // The middle ray is on the inner side.
            inside += n * across(i, PLANES, c);
            length += Math.abs(directions[3 * i + c]);
            size += Math.abs(origins[3 * i + c])
                    + Math.abs(origins[3 * j + c])
                    + Math.abs(directions[3 * i + c])
                    + Math.abs(directions[3 * j + c]);
        }
        if (inside < 0) {
            for (int c = 0; c < 3; c++) {
                normals[3 * i + c] = -normals[3 * i + c];
            }
        }
        errors[i] = PLANE_ERROR * length * size;
    }

    /**
     * A component of the vector from the point of corner ray i at t = 1 to that of ray j. Both differences cancel to their last digit: of
     * parallel rays the first may be as small as one likes beside the directions, of rays from one eye it is 0.
     */
    private double across(int i, int j, int c) {
        return (origins[3 * j + c] - origins[3 * i + c]) + (directions[3 * j + c] - directions[3 * i + c]);
    }

    /** Collects the indices of the boxes that rays of the tile may hit; returns their number. */
    public int gather(Bounds[] bounds, int[] out) {
        int n = 0;
        for (int id = 0; id < bounds.length; id++) {
            if (reaches(bounds[id])) {
                out[n++] = id;
            }
        }
        return n;
    }

    private boolean reaches(Bounds box) {
        for (int i = 0; i < PLANES; i++) {
            if (isBeyond(box, i)) {
                return false;
            }
        }
        return true;
    }

    /** Whether all corners of the box lie outside the plane. */
    private boolean isBeyond(Bounds box, int plane) {
        double distance = 0;
        double size = 0;
        for (int c = 0; c < 3; c++) {
            double n = normals[3 * plane + c];
            double min = box.min().component(c);
            double max = box.max().component(c);
            double o = origins[3 * plane + c];
            distance += n * ((n > 0 ? max : min) - o);
            // The bound covers both corners: the sign of a normal's component near 0 is random.
            size += Math.max(Math.abs(min - o), Math.abs(max - o)) + Math.max(Math.abs(min), Math.abs(max));
        }
        return distance < -errors[plane] * size;
    }
}
