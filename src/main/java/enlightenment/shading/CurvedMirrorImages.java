package enlightenment.shading;

import enlightenment.compiled.CompiledCamera;
import enlightenment.compiled.CompiledScene;
import enlightenment.compiled.EyeProjection;
import enlightenment.compiled.PhysicalLight;
import enlightenment.frame.Basis;
import enlightenment.frame.Bounds;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Ray;
import java.util.ArrayList;
import java.util.List;

/**
 * Finds where the eye sees the ball around a light in a mirror of any shape: places on the film whose reflected ray passes its centre, by
 * Newton's method from a grid of camera rays, and what the ball looks like there to first order, an ellipse. Images may be missed, and the
 * ellipse may not fit; such light is left to chance. What hides mirror or light is not looked at. A mutable work object, one per thread.
 */
final class CurvedMirrorImages {
    /** So many camera rays are beside each other over the mirror's box on the film, and above each other. */
    private static final int GRID = 48;

    private static final int STEPS = 24;
    private static final int HALVINGS = 8;

    /** Of a cell of the grid: the step of difference quotients, and of Newton's method where it has come to its end. */
    private static final double DIFFERENCE = 0x1p-12;

    private static final double SETTLED = 0x1p-24;

    /** Corners of the polygon around the ellipse. */
    private static final int CORNERS = 8;

    /** The polygon is so much larger than what first order says. */
    private static final double MARGIN = 1.125;

    private final CompiledScene scene;
    private final CompiledCamera camera;
    private final EyeProjection eye;
    private final Ray ray = new Ray();
    private final Hit hit = new Hit();
    private final Basis basis = new Basis();

    private Primitive mirror;
    private int face;
    private boolean isOutsideOnly;
    private PhysicalLight light;

    /** The box of the mirror on the film, 0..1, and a cell of the grid. */
    private double left;

    private double top;
    private double width;
    private double height;

    /** By how much the last reflected ray misses the centre: the vector from there to its nearest point. */
    private double missX;

    private double missY;
    private double missZ;

    /** Where Newton's method is, and there the derivatives of the miss across the reflected ray: first index across, second on the film. */
    private double u;

    private double v;
    private final double[][] derivative = new double[2][2];
    private final double[] miss = new double[2];
    private double determinant;

    CurvedMirrorImages(CompiledScene scene) {
        this.scene = scene;
        camera = scene.camera;
        eye = new EyeProjection(camera);
    }

    /**
     * Finds images of a light's ball that do not overlap.
     *
     * @param mirrorId the mirror's id
     * @param mirrorFace its face
     * @param outsideOnly whether it reflects on its outside only
     * @param lightIndex the light's index
     */
    List<LightImage> find(int mirrorId, int mirrorFace, boolean outsideOnly, int lightIndex) {
        mirror = scene.primitives[mirrorId];
        face = mirrorFace;
        isOutsideOnly = outsideOnly;
        light = scene.physical.lights[lightIndex];
        List<LightImage> found = new ArrayList<>();
        if (place(mirror.bounds())) {
            double[][] squares = squares();
            for (int row = 0; row < GRID; row++) {
                for (int column = 0; column < GRID; column++) {
                    if (isLeast(squares, column, row) && converges(column, row) && isSolved()) {
                        double[][] corners = ellipse();
                        LightImage image = new LightImage(lightIndex, light, mirrorId, face, corners[0], corners[1]);
                        if (found.stream().noneMatch(image::overlaps)) {
                            found.add(image);
                        }
                    }
                }
            }
        }
        return found;
    }

    /** Sets the box of a box on the film; returns whether there is any. The whole film where something of it is not before the eye. */
    private boolean place(Bounds box) {
        double x0 = 1;
        double y0 = 1;
        double x1 = 0;
        double y1 = 0;
        for (int k = 0; k < 8; k++) {
            boolean isBefore = eye.place(
                    (k & 1) == 0 ? box.min().x() : box.max().x(),
                    (k & 2) == 0 ? box.min().y() : box.max().y(),
                    (k & 4) == 0 ? box.min().z() : box.max().z());
            x0 = isBefore ? Math.min(x0, eye.x) : 0;
            y0 = isBefore ? Math.min(y0, eye.y) : 0;
            x1 = isBefore ? Math.max(x1, eye.x) : 1;
            y1 = isBefore ? Math.max(y1, eye.y) : 1;
            if (!isBefore) {
                break;
            }
        }
        left = Math.max(x0, 0);
        top = Math.max(y0, 0);
        width = (Math.min(x1, 1) - left) / GRID;
        height = (Math.min(y1, 1) - top) / GRID;
        return width > 0 && height > 0;
    }

    /** The squares of misses in the middles of cells; infinite where no ray is reflected towards the light. */
    private double[][] squares() {
        double[][] squares = new double[GRID][GRID];
        for (int row = 0; row < GRID; row++) {
            for (int column = 0; column < GRID; column++) {
                squares[row][column] = misses(left + (column + 0.5) * width, top + (row + 0.5) * height)
                        ? square()
                        : Double.POSITIVE_INFINITY;
            }
        }
        return squares;
    }

    private double square() {
        return missX * missX + missY * missY + missZ * missZ;
    }

    private static boolean isLeast(double[][] squares, int column, int row) {
        double here = squares[row][column];
        boolean isLeast = here < Double.POSITIVE_INFINITY;
        for (int y = Math.max(row - 1, 0); isLeast && y <= Math.min(row + 1, GRID - 1); y++) {
            for (int x = Math.max(column - 1, 0); x <= Math.min(column + 1, GRID - 1); x++) {
                isLeast &= here <= squares[y][x];
            }
        }
        return isLeast;
    }

    /** Sets by how much the ray through a place is reflected past the light; returns whether it is, towards it. */
    private boolean misses(double x, double y) {
        camera.ray(x, y, ray);
        if (!mirror.intersect(ray, hit) || hit.face != face || isOutsideOnly && hit.side != Ray.OUTSIDE) {
            return false;
        }
        double along = 2 * (ray.dx * hit.nx + ray.dy * hit.ny + ray.dz * hit.nz);
        double scale = 1 / Math.sqrt(ray.dd);
        double dx = scale * (ray.dx - along * hit.nx);
        double dy = scale * (ray.dy - along * hit.ny);
        double dz = scale * (ray.dz - along * hit.nz);
        double toX = light.ballX - hit.px;
        double toY = light.ballY - hit.py;
        double toZ = light.ballZ - hit.pz;
        double ahead = toX * dx + toY * dy + toZ * dz;
        missX = ahead * dx - toX;
        missY = ahead * dy - toY;
        missZ = ahead * dz - toZ;
        basis.around(dx, dy, dz);
        return ahead > 0;
    }

    /** Follows Newton's method from the middle of a cell; returns whether it ends in a place. */
    private boolean converges(int column, int row) {
        u = left + (column + 0.5) * width;
        v = top + (row + 0.5) * height;
        for (int step = 0; step < STEPS; step++) {
            if (!differentiate()) {
                return false;
            }
            double du = -(derivative[1][1] * miss[0] - derivative[0][1] * miss[1]) / determinant;
            double dv = -(derivative[0][0] * miss[1] - derivative[1][0] * miss[0]) / determinant;
            double cells = Math.max(Math.abs(du) / width, Math.abs(dv) / height);
            if (!(cells < Double.POSITIVE_INFINITY)) {
                return false;
            }
            if (cells <= SETTLED) {
                return true;
            }
            double part = Math.min(1, 1 / cells);
            double before = miss[0] * miss[0] + miss[1] * miss[1];
            int halvings = 0;
            while (!(misses(u + part * du, v + part * dv) && square() < before)) {
                if (++halvings > HALVINGS) {
                    // Nothing is nearer: rounding, or an edge of the mirror.
                    return true;
                }
                part /= 2;
            }
            u += part * du;
            v += part * dv;
        }
        return true;
    }

    /** Sets miss and derivatives where Newton's method is; returns whether the place has any. */
    private boolean differentiate() {
        if (!misses(u, v)) {
            return false;
        }
        double ax = basis.ax;
        double ay = basis.ay;
        double az = basis.az;
        double bx = basis.bx;
        double by = basis.by;
        double bz = basis.bz;
        double x = missX;
        double y = missY;
        double z = missZ;
        for (int k = 0; k < 2; k++) {
            double step = DIFFERENCE * (k == 0 ? width : height);
            // At an edge of the mirror there is one side.
            if (!misses(u + (k == 0 ? step : 0), v + (k == 1 ? step : 0))) {
                step = -step;
                if (!misses(u + (k == 0 ? step : 0), v + (k == 1 ? step : 0))) {
                    return false;
                }
            }
            derivative[0][k] = ((missX - x) * ax + (missY - y) * ay + (missZ - z) * az) / step;
            derivative[1][k] = ((missX - x) * bx + (missY - y) * by + (missZ - z) * bz) / step;
        }
        miss[0] = x * ax + y * ay + z * az;
        miss[1] = x * bx + y * by + z * bz;
        determinant = derivative[0][0] * derivative[1][1] - derivative[0][1] * derivative[1][0];
        return determinant != 0;
    }

    /** Whether the reflected ray meets the light's ball; {@link #differentiate} tells of it then. */
    private boolean isSolved() {
        return differentiate() && miss[0] * miss[0] + miss[1] * miss[1] <= light.ballRadius * light.ballRadius;
    }

    /** The x and the y of the corners of a polygon around the places whose rays meet the ball, to first order, as {@link LightImage} has them. */
    private double[][] ellipse() {
        double radius = MARGIN * light.ballRadius / StrictMath.cos(Math.PI / CORNERS);
        double[][] corners = new double[2][CORNERS];
        for (int k = 0; k < CORNERS; k++) {
            // Around the other way if the derivative turns round the wrong way.
            double turn = Math.copySign(2 * Math.PI * k / CORNERS, determinant);
            double a = radius * StrictMath.cos(turn) - miss[0];
            double b = radius * StrictMath.sin(turn) - miss[1];
            corners[0][k] = camera.columns * (u + (derivative[1][1] * a - derivative[0][1] * b) / determinant);
            corners[1][k] = camera.rows * (v + (derivative[0][0] * b - derivative[1][0] * a) / determinant);
        }
        return corners;
    }
}
