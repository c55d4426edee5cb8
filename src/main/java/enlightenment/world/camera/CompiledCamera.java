package enlightenment.world.camera;

import enlightenment.camera.Camera;
import enlightenment.frame.Bounds;
import enlightenment.frame.Rotation;
import enlightenment.frame.SceneFrame;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;

/**
 * A camera in the scene's frame: it makes the ray of a position in the picture.
 *
 * <p>All cameras have one affine form: origin and direction are linear in the position (x, y), 0..1 from the upper left.
 */
public final class CompiledCamera {
    /** Rays of the isometric view start this far behind the picture's plane: every coordinate of the frame is below 2. */
    private static final double BEHIND_EVERYTHING = -16;

    final Vec3 origin;
    final Vec3 originX;
    final Vec3 originY;
    final Vec3 direction;
    final Vec3 directionX;
    final Vec3 directionY;
    final double tMin;

    /** The picture's width and height in pixels. */
    public final int columns;

    public final int rows;

    private CompiledCamera(
            Vec3 origin,
            Vec3 originX,
            Vec3 originY,
            Vec3 direction,
            Vec3 directionX,
            Vec3 directionY,
            double tMin,
            int columns,
            int rows) {
        this.columns = columns;
        this.rows = rows;
        this.origin = origin;
        this.originX = originX;
        this.originY = originY;
        this.direction = direction;
        this.directionX = directionX;
        this.directionY = directionY;
        this.tMin = tMin;
    }

    /**
     * The camera in a frame whose origin is {@link Camera#origin}.
     *
     * @param width the picture's width in pixels
     * @param height its height; cameras without a window take the aspect ratio from the picture
     */
    public static CompiledCamera of(Camera camera, SceneFrame frame, int width, int height) {
        if (camera instanceof Camera.Window w) {
            return window(w, frame, width, height);
        }
        if (camera instanceof Camera.Perspective p) {
            return perspective(p, width, height);
        }
        if (camera instanceof Camera.Orthographic o) {
            View view = new View(o.eye().directionTo(o.lookAt()), o.up());
            return parallel(view, frame.toFrame(o.height()) / 2, 0, width, height);
        }
        if (camera instanceof Camera.Isometric i) {
            // Seen along (1, -1, 1), an upright edge of length 1 is √(2/3) high; in units of the drawing it is 1.
            double half = frame.toFrame(i.height()) / 2 * Math.sqrt(2.0 / 3);
            return parallel(new View(new Vec3(1, -1, 1), Vec3.Y), half, BEHIND_EVERYTHING, width, height);
        }
        throw new AssertionError("no compiled form of the camera " + camera.type());
    }

    private static CompiledCamera window(Camera.Window w, SceneFrame frame, int width, int height) {
        Vec3 upperLeft = frame.toFrame(w.upperLeft());
        Vec3 right = frame.toFrame(w.upperRight()).minus(upperLeft);
        Vec3 down = frame.toFrame(w.lowerLeft()).minus(upperLeft);
        // The eye is the frame's origin; t = 1 is the window, and what lies before it is not seen.
        return new CompiledCamera(Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, upperLeft, right, down, 1, width, height);
    }

    private static CompiledCamera perspective(Camera.Perspective p, int width, int height) {
        View v = new View(p.eye().directionTo(p.lookAt()), p.up());
        double half = Rotation.sin(p.fieldOfView() / 2) / Rotation.cos(p.fieldOfView() / 2);
        Vec3 toRight = v.right.times(half * ((double) width / height));
        Vec3 toTop = v.up.times(half);
        Vec3 corner = v.forward.plus(toTop).minus(toRight);
        return new CompiledCamera(
                Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, corner, toRight.times(2), toTop.times(-2), 0, width, height);
    }

    private static CompiledCamera parallel(View v, double halfHeight, double from, int width, int height) {
        Vec3 toRight = v.right.times(halfHeight * ((double) width / height));
        Vec3 toTop = v.up.times(halfHeight);
        return new CompiledCamera(
                toTop.minus(toRight),
                toRight.times(2),
                toTop.times(-2),
                v.forward,
                Vec3.ZERO,
                Vec3.ZERO,
                from,
                width,
                height);
    }

    /** A box around the places where rays start. */
    public Bounds startBounds() {
        Ray r = new Ray();
        Vec3[] corners = new Vec3[4];
        for (int i = 0; i < 4; i++) {
            ray(i & 1, i >> 1, r);
            corners[i] = new Vec3(r.ox, r.oy, r.oz).plus(new Vec3(r.dx, r.dy, r.dz).times(r.tMin));
        }
        Bounds box = Bounds.of(corners);
        return Bounds.around(box.center(), box.extent());
    }

    /** The places where rays start. */
    public RayStarts rayStarts() {
        Vec3 size = absolute(origin)
                .plus(absolute(originX))
                .plus(absolute(originY))
                .plus(absolute(direction)
                        .plus(absolute(directionX))
                        .plus(absolute(directionY))
                        .times(Math.abs(tMin)));
        return new RayStarts(
                startBounds(),
                origin.plus(direction.times(tMin)),
                originX.plus(directionX.times(tMin)),
                originY.plus(directionY.times(tMin)),
                size);
    }

    private static Vec3 absolute(Vec3 v) {
        return new Vec3(Math.abs(v.x()), Math.abs(v.y()), Math.abs(v.z()));
    }

    /** Sets the ray through (x, y), 0..1 from the picture's upper left corner. */
    public void ray(double x, double y, Ray ray) {
        ray.set(
                Math.fma(x, originX.x(), Math.fma(y, originY.x(), origin.x())),
                Math.fma(x, originX.y(), Math.fma(y, originY.y(), origin.y())),
                Math.fma(x, originX.z(), Math.fma(y, originY.z(), origin.z())),
                Math.fma(x, directionX.x(), Math.fma(y, directionY.x(), direction.x())),
                Math.fma(x, directionX.y(), Math.fma(y, directionY.y(), direction.y())),
                Math.fma(x, directionX.z(), Math.fma(y, directionY.z(), direction.z())),
                tMin);
    }

    /** Orthonormal axes of a view: in the paper's axes, right is +x and up is +y for a viewer who looks along +z. */
    private static final class View {
        final Vec3 forward;
        final Vec3 right;
        final Vec3 up;

        View(Vec3 along, Vec3 upwards) {
            forward = along.normalized();
            right = upwards.normalized().cross(forward).normalized();
            up = forward.cross(right);
        }
    }
}
