package enlightenment.world.camera;

import enlightenment.camera.Camera;
import enlightenment.frame.Bounds;
import enlightenment.frame.Rotation;
import enlightenment.frame.SceneFrame;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;

/**
 * A camera whose origin and direction are linear in the position (x, y), 0..1 from the upper left: every camera but the panorama. A lens is a
 * set of such cameras.
 */
final class AffineCamera extends CompiledCamera {
    /** Rays of the isometric view start this far behind the picture's plane: every coordinate of the frame is below 2. */
    private static final double BEHIND_EVERYTHING = -16;

    final Vec3 origin;
    final Vec3 originX;
    final Vec3 originY;
    final Vec3 direction;
    final Vec3 directionX;
    final Vec3 directionY;
    final double tMin;

    /** The lens; null for a pinhole or a parallel view. */
    final ThinLens lens;

    private AffineCamera(Linear start, Linear along, double tMin, ThinLens lens, int columns, int rows) {
        super(columns, rows);
        origin = start.at;
        originX = start.right;
        originY = start.down;
        direction = along.at;
        directionX = along.right;
        directionY = along.down;
        this.tMin = tMin;
        this.lens = lens;
    }

    /** The point or vector {@code at + x right + y down} at the film position (x, y). */
    private record Linear(Vec3 at, Vec3 right, Vec3 down) {
        static final Linear ZERO = new Linear(Vec3.ZERO, Vec3.ZERO, Vec3.ZERO);

        static Linear constant(Vec3 v) {
            return new Linear(v, Vec3.ZERO, Vec3.ZERO);
        }
    }

    static AffineCamera compile(Camera camera, SceneFrame frame, int width, int height) {
        if (camera instanceof Camera.Window w) {
            return window(w, frame, width, height);
        }
        if (camera instanceof Camera.Perspective p) {
            return perspective(p, frame, width, height);
        }
        if (camera instanceof Camera.Orthographic o) {
            View view = new View(o.eye().directionTo(o.lookAt()), o.up(), o.handedness());
            return parallel(view, frame.toFrame(o.height()) / 2, 0, width, height);
        }
        if (camera instanceof Camera.Isometric i) {
            // Seen along (1, -1, 1), an upright edge of length 1 is √(2/3) high; in units of the drawing it is 1.
            double half = frame.toFrame(i.height()) / 2 * Math.sqrt(2.0 / 3);
            View view = new View(new Vec3(1, -1, 1), Vec3.Y, Camera.Handedness.LEFT);
            return parallel(view, half, BEHIND_EVERYTHING, width, height);
        }
        throw new AssertionError("no compiled form of the camera " + camera.type());
    }

    private static AffineCamera window(Camera.Window w, SceneFrame frame, int width, int height) {
        Vec3 upperLeft = frame.toFrame(w.upperLeft());
        Vec3 right = frame.toFrame(w.upperRight()).minus(upperLeft);
        Vec3 down = frame.toFrame(w.lowerLeft()).minus(upperLeft);
        ThinLens lens = null;
        if (w.pupilRadius() > 0) {
            Vec3 normal = right.normalized().cross(down.normalized()).normalized();
            double radius = frame.toFrame(w.pupilRadius());
            Vec3 a = right.normalized().times(radius);
            Vec3 b = normal.cross(right.normalized()).times(radius);
            // The window is at t = 1.
            lens = new ThinLens(Aperture.ROUND, a, b, a, b);
        }
        // The eye is the frame's origin; the window is at t = 1, and nothing before it is seen.
        return new AffineCamera(Linear.ZERO, new Linear(upperLeft, right, down), 1, lens, width, height);
    }

    private static AffineCamera perspective(Camera.Perspective p, SceneFrame frame, int width, int height) {
        View v = new View(p.eye().directionTo(p.lookAt()), p.up(), p.handedness());
        double half = Rotation.sin(p.fieldOfView() / 2) / Rotation.cos(p.fieldOfView() / 2);
        boolean spansWidth = p.axis().spansWidth(width, height);
        Vec3 toRight = v.right.times(spansWidth ? half : half * ((double) width / height));
        Vec3 toTop = v.up.times(spansWidth ? half * ((double) height / width) : half);
        Vec3 corner = v.forward.plus(toTop).minus(toRight);
        ThinLens lens = null;
        if (p.lens().isPresent() && p.lens().get().radius() > 0) {
            Camera.Lens l = p.lens().get();
            double radius = frame.toFrame(l.radius());
            // The direction has length 1 along the view.
            double slope = l.radius() / l.focusDistance();
            lens = new ThinLens(
                    new Aperture(l.blades(), l.rotation()),
                    v.right.times(radius),
                    v.up.times(radius),
                    v.right.times(slope),
                    v.up.times(slope));
        }
        Linear along = new Linear(corner, toRight.times(2), toTop.times(-2));
        return new AffineCamera(Linear.ZERO, along, 0, lens, width, height);
    }

    private static AffineCamera parallel(View v, double halfHeight, double from, int width, int height) {
        Vec3 toRight = v.right.times(halfHeight * ((double) width / height));
        Vec3 toTop = v.up.times(halfHeight);
        Linear start = new Linear(toTop.minus(toRight), toRight.times(2), toTop.times(-2));
        return new AffineCamera(start, Linear.constant(v.forward), from, null, width, height);
    }

    @Override
    public boolean hasLens() {
        return lens != null;
    }

    @Override
    public CompiledCamera withoutLens() {
        return lens == null
                ? this
                : new AffineCamera(
                        new Linear(origin, originX, originY),
                        new Linear(direction, directionX, directionY),
                        tMin,
                        null,
                        columns,
                        rows);
    }

    @Override
    public boolean isPinholeOrParallel() {
        return lens == null;
    }

    @Override
    public Bounds startBounds() {
        if (startsOnLens()) {
            Vec3 a = lens.right();
            Vec3 b = lens.up();
            Vec3[] corners = {a.plus(b), a.minus(b), b.minus(a), a.plus(b).times(-1)};
            return doubled(corners);
        }
        Ray r = new Ray();
        Vec3[] corners = new Vec3[4];
        for (int i = 0; i < 4; i++) {
            ray(i & 1, i >> 1, r);
            corners[i] = new Vec3(r.ox, r.oy, r.oz).plus(new Vec3(r.dx, r.dy, r.dz).times(r.tMin));
        }
        return doubled(corners);
    }

    private static Bounds doubled(Vec3... corners) {
        Bounds box = Bounds.of(corners);
        return Bounds.around(box.center(), box.extent());
    }

    /** Whether rays start on the lens: not where there is a window, as they start at that. */
    private boolean startsOnLens() {
        return lens != null && tMin == 0;
    }

    @Override
    public RayStarts rayStarts() {
        Vec3 wide = lens == null ? Vec3.ZERO : absolute(lens.right()).plus(absolute(lens.up()));
        if (startsOnLens()) {
            Vec3 corner = lens.right().plus(lens.up()).times(-1);
            return new RayStarts(
                    startBounds(), corner, lens.right().times(2), lens.up().times(2), wide);
        }
        Vec3 size = absolute(origin)
                .plus(absolute(originX))
                .plus(absolute(originY))
                .plus(absolute(direction)
                        .plus(absolute(directionX))
                        .plus(absolute(directionY))
                        .plus(wide)
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

    @Override
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

    @Override
    public void ray(double x, double y, Sampler sampler, Ray ray) {
        ray(x, y, ray);
        if (lens == null) {
            return;
        }
        double[] pair = new double[2];
        sampler.pair(0, Sampler.Purpose.LENS, pair);
        double[] point = lens.sample(pair[0], pair[1]);
        Vec3 start = lens.start(point);
        Vec3 turn = lens.turn(point);
        ray.set(start.x(), start.y(), start.z(), ray.dx - turn.x(), ray.dy - turn.y(), ray.dz - turn.z(), tMin);
    }

    @Override
    public double[] linearForm() {
        double[] all = new double[19];
        Vec3[] parts = {origin, originX, originY, direction, directionX, directionY};
        for (int k = 0; k < 18; k++) {
            all[k] = parts[k / 3].component(k % 3);
        }
        all[18] = tMin;
        return all;
    }

    @Override
    public double[] lensForm() {
        return lens == null ? super.lensForm() : lens.flatForm();
    }
}
