package enlightenment.transport.image;

import enlightenment.frame.Basis;
import enlightenment.frame.Bounds;
import enlightenment.world.CompiledScene;
import enlightenment.world.camera.CompiledCamera;
import enlightenment.world.camera.EyeProjection;
import enlightenment.world.light.PhysicalLight;

/**
 * Finds places on the film whose rays, after what happens to them on their way, pass the centre of the ball around a light: by Newton's
 * method from cells of a grid, and what the ball looks like there to first order, an ellipse. Images may be missed, and the ellipse may not
 * fit; such light is left to chance. A mutable work object, one per thread.
 */
abstract class ImageSolver {
    private static final int STEPS = 24;
    private static final int HALVINGS = 8;

    /** Of a cell of the grid: the step of difference quotients, and of Newton's method where it has come to its end. */
    private static final double DIFFERENCE = 0x1p-12;

    private static final double SETTLED = 0x1p-24;

    /** So many cells off is no place where neighbours would be further off than the nearest cell. */
    private static final double FAR = 8;

    /** Where the ball covers so many pixels there, samples find it without help. */
    private static final double LARGE = 64;

    /** Corners of the polygon around the ellipse. */
    private static final int CORNERS = 8;

    /** The polygon is so much larger than what first order says. */
    private static final double MARGIN = 1.125;

    final CompiledScene scene;
    final CompiledCamera camera;
    private final EyeProjection eye;
    private final Basis basis = new Basis();

    /** The light that is sought. */
    PhysicalLight light;

    /** The box on the film, 0..1, that the grid covers, and a cell of the grid. */
    private double left;

    private double top;
    private double width;
    private double height;

    /** By how much the last ray misses the centre: the vector from there to its nearest point. */
    private double missX;

    private double missY;
    private double missZ;

    /** How far from where the ray begins that nearest point is. */
    double ahead;

    /** Where Newton's method is, and there the derivatives of the miss across the ray: first index across, second on the film. */
    private double u;

    private double v;
    private final double[][] derivative = new double[2][2];
    private final double[] miss = new double[2];
    private double determinant;

    /** The corners of the last image, as {@link LightImage} has them. */
    double[] x;

    double[] y;

    ImageSolver(CompiledScene scene) {
        this.scene = scene;
        camera = scene.camera;
        eye = new EyeProjection(camera);
    }

    /**
     * Lays a grid over where a box is on the film; over the whole film where something of it is not before the eye.
     *
     * @param side how many cells there are beside each other, and above each other
     * @return whether there is anything of it
     */
    final boolean lay(Bounds box, int side) {
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
        width = (Math.min(x1, 1) - left) / side;
        height = (Math.min(y1, 1) - top) / side;
        return width > 0 && height > 0;
    }

    /** The middle of a cell's column on the film, 0..1. */
    final double middleX(int column) {
        return left + (column + 0.5) * width;
    }

    /** The middle of a cell's row. */
    final double middleY(int row) {
        return top + (row + 0.5) * height;
    }

    /**
     * Follows the ray through a place, and tells {@link #passes} of where it goes.
     *
     * @return whether it gets there, and comes near to the light at all
     */
    abstract boolean misses(double atX, double atY);

    /**
     * Sets by how much a ray misses the light; returns whether that is before it.
     *
     * @param px where it begins
     * @param dx its unit direction
     */
    final boolean passes(double px, double py, double pz, double dx, double dy, double dz) {
        double toX = light.ballX - px;
        double toY = light.ballY - py;
        double toZ = light.ballZ - pz;
        ahead = toX * dx + toY * dy + toZ * dz;
        missX = ahead * dx - toX;
        missY = ahead * dy - toY;
        missZ = ahead * dz - toZ;
        basis.around(dx, dy, dz);
        return ahead > 0;
    }

    /** The square of how far the last ray is from the light's centre. */
    final double square() {
        return missX * missX + missY * missY + missZ * missZ;
    }

    /**
     * Looks for an image from the middle of a cell: sets its {@linkplain #x corners}.
     *
     * @param squares {@link #square} at the middles of cells, row by row; infinite where a ray does not get there
     * @param side the grid's
     * @return whether there is one
     */
    final boolean solve(double[] squares, int side, int column, int row) {
        if (!isLeast(squares, side, column, row) || !converges(column, row) || !isSolved()) {
            return false;
        }
        setEllipse();
        return true;
    }

    private static boolean isLeast(double[] squares, int side, int column, int row) {
        double here = squares[side * row + column];
        boolean isLeast = here < Double.POSITIVE_INFINITY;
        for (int j = Math.max(row - 1, 0); isLeast && j <= Math.min(row + 1, side - 1); j++) {
            for (int k = Math.max(column - 1, 0); k <= Math.min(column + 1, side - 1); k++) {
                isLeast &= here <= squares[side * j + k];
            }
        }
        return isLeast;
    }

    /** Follows Newton's method from the middle of a cell; returns whether it ends in a place. */
    private boolean converges(int column, int row) {
        u = middleX(column);
        v = middleY(row);
        for (int step = 0; step < STEPS; step++) {
            if (!differentiate()) {
                return false;
            }
            double du = -(derivative[1][1] * miss[0] - derivative[0][1] * miss[1]) / determinant;
            double dv = -(derivative[0][0] * miss[1] - derivative[1][0] * miss[0]) / determinant;
            double cells = Math.max(Math.abs(du) / width, Math.abs(dv) / height);
            if (!(cells < (step == 0 ? FAR : Double.POSITIVE_INFINITY)) || isFarTooLarge()) {
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
                    // Nothing is nearer: rounding, or an edge of what the ray meets.
                    return true;
                }
                part /= 2;
            }
            u += part * du;
            v += part * dv;
        }
        return true;
    }

    private boolean isFarTooLarge() {
        double area = Math.PI * light.ballRadius * light.ballRadius * camera.columns * camera.rows;
        return area > LARGE * Math.abs(determinant);
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
        double x0 = missX;
        double y0 = missY;
        double z0 = missZ;
        for (int k = 0; k < 2; k++) {
            double step = DIFFERENCE * (k == 0 ? width : height);
            // At an edge there is one side.
            if (!misses(u + (k == 0 ? step : 0), v + (k == 1 ? step : 0))) {
                step = -step;
                if (!misses(u + (k == 0 ? step : 0), v + (k == 1 ? step : 0))) {
                    return false;
                }
            }
            derivative[0][k] = ((missX - x0) * ax + (missY - y0) * ay + (missZ - z0) * az) / step;
            derivative[1][k] = ((missX - x0) * bx + (missY - y0) * by + (missZ - z0) * bz) / step;
        }
        miss[0] = x0 * ax + y0 * ay + z0 * az;
        miss[1] = x0 * bx + y0 * by + z0 * bz;
        determinant = derivative[0][0] * derivative[1][1] - derivative[0][1] * derivative[1][0];
        return determinant != 0;
    }

    /** Whether the ray meets the light's ball; {@link #differentiate} tells of it then. */
    private boolean isSolved() {
        return differentiate() && miss[0] * miss[0] + miss[1] * miss[1] <= light.ballRadius * light.ballRadius;
    }

    /** Sets the corners of a polygon around the places whose rays meet the ball, to first order. */
    private void setEllipse() {
        double radius = MARGIN * light.ballRadius / StrictMath.cos(Math.PI / CORNERS);
        x = new double[CORNERS];
        y = new double[CORNERS];
        for (int k = 0; k < CORNERS; k++) {
            // Around the other way if the derivative turns round the wrong way.
            double turn = Math.copySign(2 * Math.PI * k / CORNERS, determinant);
            double a = radius * StrictMath.cos(turn) - miss[0];
            double b = radius * StrictMath.sin(turn) - miss[1];
            x[k] = camera.columns * (u + (derivative[1][1] * a - derivative[0][1] * b) / determinant);
            y[k] = camera.rows * (v + (derivative[0][0] * b - derivative[1][0] * a) / determinant);
        }
    }
}
