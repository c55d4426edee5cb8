package enlightenment.world.light;

import enlightenment.frame.Basis;
import enlightenment.math.Vec3;
import enlightenment.primitive.AxialPrimitive;
import enlightenment.primitive.DiskPrimitive;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SupportSurface;
import enlightenment.world.camera.CompiledCamera;
import enlightenment.world.camera.EyeProjection;
import java.util.Arrays;

/**
 * The outlines of lights on the film: convex polygons around the light's surface or its bounding ball. Circles get enough corners that none
 * is farther than a thousandth of a pixel from the circle. A mutable work object, one per thread.
 */
final class LightOutline {
    /** The least and the largest number of corners of a circle, powers of two. */
    private static final int LEAST_CORNERS = 16;

    private static final int MOST_CORNERS = 512;

    /** Twice the largest distance of a corner from a circle, in pixels. */
    private static final double SAGITTA = 0x1p-9;

    /** Beyond this number of pixels from the corner of the picture, the rounding of a position is no small part of a pixel. */
    private static final double FAR = 0x1p30;

    private final CompiledCamera camera;
    private final EyeProjection eye;
    private final Vec3 eyePoint;
    private final Vec3 forward;
    private final Basis basis = new Basis();
    private double[][] points = new double[0][];
    private int size;
    private boolean isBefore;

    /** Whether the outline is that of the light itself, up to the roundness of arcs, not of its bounding ball. */
    boolean isExact;

    /** The corners of the outline, in pixels. */
    double[] x;

    double[] y;

    LightOutline(CompiledCamera camera) {
        this.camera = camera;
        eye = EyeProjection.of(camera);
        Ray middle = new Ray();
        camera.ray(0.5, 0.5, middle);
        eyePoint = new Vec3(middle.ox, middle.oy, middle.oz);
        forward = new Vec3(middle.dx, middle.dy, middle.dz);
    }

    /**
     * Finds the polygon around a light.
     *
     * @return whether there is one in the picture: all of the light lies before the eye, and its emitting side may be visible
     */
    boolean find(PhysicalLight l) {
        SupportSurface s = l.surface.support(l.face);
        if (s instanceof SupportSurface.Plane p && !isLit(p, l) || !trace(l, s, LEAST_CORNERS)) {
            return false;
        }
        double across = 0;
        for (int k = 0; k < size; k++) {
            across = Math.max(
                    across, Math.max(Math.abs(points[k][0] - points[0][0]), Math.abs(points[k][1] - points[0][1])));
        }
        // A corner of n around a circle of radius r lies r (1/cos(π/n) − 1) ≈ r π²/(2 n²) beside it.
        double wanted = Math.PI * Math.sqrt(across / SAGITTA);
        int corners = LEAST_CORNERS;
        while (corners < MOST_CORNERS && corners < wanted) {
            corners *= 2;
        }
        return (corners == LEAST_CORNERS || trace(l, s, corners)) && reachesPicture() && wrap();
    }

    /** Whether the eye is on an emitting side of a plane: not behind a face of an opaque solid, whose other faces hide it. */
    private boolean isLit(SupportSurface.Plane p, PhysicalLight l) {
        Vec3 normal = p.unitNormal();
        double above = eye.isParallel() ? -normal.dot(forward) : normal.dot(eyePoint.minus(p.corners()[0]));
        return above > 0 ? l.shinesOutside : l.shinesInside;
    }

    /** Sets the points that the outline surrounds; returns whether all of them are before the eye. */
    private boolean trace(PhysicalLight l, SupportSurface s, int corners) {
        if (points.length < 2 * corners) {
            points = new double[2 * corners][2];
        }
        size = 0;
        isBefore = true;
        isExact = true;
        if (s instanceof SupportSurface.Plane p) {
            plane(l, p, corners);
        } else if (s instanceof SupportSurface.Lateral t) {
            Vec3 axis = t.axis().normalized();
            basis.around(axis.x(), axis.y(), axis.z());
            round(t.base(), t.baseRadius(), corners);
            round(t.top(), t.topRadius(), corners);
        } else {
            isExact = s instanceof SupportSurface.Ball;
            ball(new Vec3(l.ballX, l.ballY, l.ballZ), l.ballRadius, corners);
        }
        return isBefore;
    }

    private void plane(PhysicalLight l, SupportSurface.Plane p, int corners) {
        Vec3[] c = p.corners();
        if (l.surface instanceof DiskPrimitive || l.surface instanceof AxialPrimitive) {
            Vec3 center = c[0].plus(c[2]).times(0.5);
            circle(center, c[0].minus(c[1]).times(0.5), c[1].minus(c[2]).times(0.5), corners);
            return;
        }
        for (Vec3 corner : c) {
            add(corner);
        }
    }

    /** Adds corners around a circle whose axis is that of the basis. */
    private void round(Vec3 center, double radius, int corners) {
        Vec3 a = new Vec3(radius * basis.ax, radius * basis.ay, radius * basis.az);
        Vec3 b = new Vec3(radius * basis.bx, radius * basis.by, radius * basis.bz);
        circle(center, a, b, corners);
    }

    /**
     * Adds corners around the disk through a ball's centre that the ball looks like from the eye: larger than the ball, as the eye's cone
     * is oblique to its axis.
     */
    private void ball(Vec3 center, double radius, int corners) {
        Vec3 axis = forward;
        double size = radius;
        if (!eye.isParallel()) {
            axis = center.minus(eyePoint);
            double d = axis.length();
            if (!(d > radius)) {
                isBefore = false;
                return;
            }
            size /= Math.sqrt((1 - radius / d) * (1 + radius / d));
        }
        axis = axis.normalized();
        basis.around(axis.x(), axis.y(), axis.z());
        round(center, size, corners);
    }

    private void circle(Vec3 center, Vec3 a, Vec3 b, int corners) {
        double outer = 1 / StrictMath.cos(Math.PI / corners);
        int step = MOST_CORNERS / corners;
        for (int k = 0; k < MOST_CORNERS; k += step) {
            add(center.plus(a.times(outer * Circle.COSINES[k])).plus(b.times(outer * Circle.SINES[k])));
        }
    }

    private void add(Vec3 p) {
        isBefore &= eye.place(p.x(), p.y(), p.z());
        points[size][0] = eye.x * camera.columns;
        points[size][1] = eye.y * camera.rows;
        isBefore &= Math.abs(points[size][0]) < FAR && Math.abs(points[size][1]) < FAR;
        size++;
    }

    /** Whether the box around the points overlaps the picture: hulls of others are of no use. */
    private boolean reachesPicture() {
        double left = points[0][0];
        double right = left;
        double top = points[0][1];
        double bottom = top;
        for (int k = 1; k < size; k++) {
            left = Math.min(left, points[k][0]);
            right = Math.max(right, points[k][0]);
            top = Math.min(top, points[k][1]);
            bottom = Math.max(bottom, points[k][1]);
        }
        return left < camera.columns && right > 0 && top < camera.rows && bottom > 0;
    }

    /**
     * Sets the outline to the convex hull of the points: A. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979.
     */
    private boolean wrap() {
        double[][] sorted = Arrays.copyOf(points, size);
        Arrays.sort(sorted, LightOutline::compare);
        double[][] hull = new double[2 * size][];
        int n = 0;
        for (int k = 0; k < size; k++) {
            n = push(hull, n, 2, sorted[k]);
        }
        int lower = n + 1;
        for (int k = size - 2; k >= 0; k--) {
            n = push(hull, n, lower, sorted[k]);
        }
        x = new double[n - 1];
        y = new double[n - 1];
        for (int k = 0; k < n - 1; k++) {
            x[k] = hull[k][0];
            y[k] = hull[k][1];
        }
        return n > 3;
    }

    /** Orders points by x, then by y. */
    private static int compare(double[] a, double[] b) {
        int byX = Double.compare(a[0], b[0]);
        return byX != 0 ? byX : Double.compare(a[1], b[1]);
    }

    private static int push(double[][] hull, int from, int least, double[] p) {
        int n = from;
        while (n >= least && !isLeftTurn(hull[n - 2], hull[n - 1], p)) {
            n--;
        }
        hull[n] = p;
        return n + 1;
    }

    private static boolean isLeftTurn(double[] a, double[] b, double[] c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0;
    }

    /** The corners of the finest polygon in the unit circle, made at the first use. */
    private static final class Circle {
        static final double[] COSINES = new double[MOST_CORNERS];
        static final double[] SINES = new double[MOST_CORNERS];

        static {
            for (int k = 0; k < MOST_CORNERS; k++) {
                double angle = 2 * Math.PI * k / MOST_CORNERS;
                COSINES[k] = StrictMath.cos(angle);
                SINES[k] = StrictMath.sin(angle);
            }
        }
    }
}
