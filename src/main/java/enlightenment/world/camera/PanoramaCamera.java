package enlightenment.world.camera;

import enlightenment.camera.Camera;
import enlightenment.frame.Bounds;
import enlightenment.frame.SceneFrame;
import enlightenment.math.Vec3;
import enlightenment.primitive.Ray;
import enlightenment.sampling.Sampler;

/**
 * All directions by longitude φ, from the middle of the picture to its right, and latitude θ upwards. A stereo pair has the left eye's panorama
 * in its upper half; the ray of longitude φ starts beside the middle between the eyes, perpendicular to φ.
 */
final class PanoramaCamera extends CompiledCamera {
    final View view;

    /** Half the distance between the eyes, in the frame; 0 for one eye. */
    final double offset;

    private PanoramaCamera(View view, double offset, int columns, int rows) {
        super(columns, rows);
        this.view = view;
        this.offset = offset;
    }

    static PanoramaCamera compile(Camera.Panorama p, SceneFrame frame, int width, int height) {
        View view = new View(p.eye().directionTo(p.lookAt()), p.up(), p.handedness());
        return new PanoramaCamera(view, frame.toFrame(p.eyeSeparation()) / 2, width, height);
    }

    @Override
    public boolean hasLens() {
        return false;
    }

    @Override
    public CompiledCamera withoutLens() {
        return this;
    }

    @Override
    public boolean isPinholeOrParallel() {
        return false;
    }

    @Override
    public void ray(double x, double y, Ray ray) {
        boolean isLeft = offset > 0 && y < 0.5;
        double height = offset == 0 ? y : isLeft ? 2 * y : 2 * y - 1;
        double longitude = 2 * Math.PI * (x - 0.5);
        double latitude = Math.PI * (0.5 - height);
        double sine = StrictMath.sin(longitude);
        double cosine = StrictMath.cos(longitude);
        double level = StrictMath.cos(latitude);
        Vec3 d = view.right
                .times(level * sine)
                .plus(view.forward.times(level * cosine))
                .plus(view.up.times(StrictMath.sin(latitude)));
        double side = isLeft ? -offset : offset;
        Vec3 start = view.right.times(side * cosine).minus(view.forward.times(side * sine));
        ray.set(start.x(), start.y(), start.z(), d.x(), d.y(), d.z(), 0);
    }

    @Override
    public void ray(double x, double y, Sampler sampler, Ray ray) {
        ray(x, y, ray);
    }

    @Override
    public Bounds startBounds() {
        return Bounds.around(Vec3.ZERO, new Vec3(2 * offset, 2 * offset, 2 * offset));
    }

    @Override
    public RayStarts rayStarts() {
        Vec3 size = new Vec3(2 * offset, 2 * offset, 2 * offset);
        return new RayStarts(startBounds(), Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, size);
    }
}
