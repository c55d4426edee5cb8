package enlightenment.physical;

import enlightenment.camera.Camera;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneObject;
import enlightenment.scene.Shading;
import java.util.ArrayList;
import java.util.List;

/** A scene's description as a list of surfaces that are all asked, one after the other. */
final class NaiveScene {
    /** How far from a surface its two sides are asked for: scenes have a size of about 1. */
    private static final double ASIDE = 1e-6;

    /** Rays do not meet what is nearer to where they start. */
    private static final double START = 1e-7;

    /**
     * A surface.
     *
     * @param material what it is made of; null for a light
     * @param front what it emits on the side of its normal
     * @param back what it emits on the other side
     */
    record Surface(NaiveShape shape, Material material, double[] front, double[] back) {
        boolean isGlass() {
            return material instanceof Glass || material instanceof Material.Scattering;
        }

        boolean isSolid() {
            return shape.volume() > 0;
        }
    }

    /** A place on a surface; the normal is on the side that the ray came from. */
    record Hit(Surface surface, double distance, Vec3 point, Vec3 normal, boolean front) {}

    /** A light without extent. */
    record Point(Vec3 position, double[] intensity) {}

    final List<Surface> surfaces = new ArrayList<>();
    final List<Point> points = new ArrayList<>();
    private final NaiveSky background;
    final int maxBounces;
    private final Scene scene;

    NaiveScene(Scene scene) {
        this.scene = scene;
        Shading.Physical shading = (Shading.Physical) scene.shading();
        background = NaiveSky.of(shading.background());
        maxBounces = shading.maxBounces().orElse(Integer.MAX_VALUE);
        for (Light light : scene.lights()) {
            add(light);
        }
        for (SceneObject object : scene.objects()) {
            double[] glow = NaiveColors.of(object.material().radiance());
            Material.EmissionPattern.Side side = object.material().pattern().side();
            surfaces.add(new Surface(
                    NaiveShape.of(object.shape()),
                    object.material(),
                    side == Material.EmissionPattern.Side.BACK ? new double[3] : glow,
                    side == Material.EmissionPattern.Side.FRONT ? new double[3] : glow));
        }
    }

    /** Whether anything scatters light beside surfaces. */
    boolean hasMedia() {
        return ((Shading.Physical) scene.shading()).medium().isPresent()
                || surfaces.stream().anyMatch(s -> s.material() instanceof Material.Scattering);
    }

    /** What comes from where nothing is. */
    double[] background(Vec3 direction) {
        return background.radiance(direction);
    }

    private void add(Light light) {
        double[] color = NaiveColors.of(light.color());
        double[] value =
                NaiveColors.product(color, NaiveColors.of(light.emission().value()));
        boolean power = light.emission().quantity() == Emission.Quantity.POWER;
        if (light instanceof Light.Sphere s) {
            double[] radiance = times(value, power ? 1 / (4 * Math.PI * Math.PI * s.radius() * s.radius()) : 1);
            surfaces.add(
                    new Surface(new NaiveShape.Ball(NaiveShape.at(s.center()), s.radius()), null, radiance, radiance));
        } else if (light instanceof Light.Rectangle r) {
            NaiveShape.Flat flat = new NaiveShape.Flat(
                    NaiveShape.at(r.upperLeft()), NaiveShape.at(r.upperRight()), NaiveShape.at(r.lowerLeft()), false);
            double sides = r.twoSided() ? 2 : 1;
            double[] radiance = times(value, power ? 1 / (sides * Math.PI * flat.area()) : 1);
            surfaces.add(new Surface(flat, null, radiance, r.twoSided() ? radiance : new double[3]));
        } else {
            Light.Point p = (Light.Point) light;
            points.add(new Point(NaiveShape.at(p.position()), times(value, power ? 1 / (4 * Math.PI) : 1)));
        }
    }

    private static double[] times(double[] v, double s) {
        return new double[] {v[0] * s, v[1] * s, v[2] * s};
    }

    /** The first surface that a ray with a direction of length 1 meets, or null. */
    Hit nearest(Vec3 o, Vec3 d) {
        double best = NaiveShape.NONE;
        Surface met = null;
        for (Surface s : surfaces) {
            double t = s.shape.hit(o, d, START);
            if (t < best) {
                best = t;
                met = s;
            }
        }
        if (met == null) {
            return null;
        }
        Vec3 p = o.plus(d.times(best));
        Vec3 n = met.shape.normal(p);
        boolean front = n.dot(d) < 0;
        return new Hit(met, best, p, front ? n : n.negated(), front);
    }

    /** The glass that fills a point: of the highest priority, and of those the smallest; null in empty space. */
    Surface medium(Vec3 p) {
        Surface best = null;
        for (Surface s : surfaces) {
            if (s.isGlass() && s.shape.contains(p)) {
                best = best == null || isBefore(s, best) ? s : best;
            }
        }
        return best;
    }

    private static boolean isBefore(Surface a, Surface b) {
        int p = NaiveMedium.boundary(a.material).priority();
        int q = NaiveMedium.boundary(b.material).priority();
        return p != q ? p > q : a.shape.volume() < b.shape.volume();
    }

    /** The glass on the side of a hit that the normal points to (sign 1), or on the other one (sign −1). */
    Surface medium(Hit hit, int sign) {
        return medium(hit.point().plus(hit.normal().times(sign * ASIDE)));
    }

    /** Index of refraction of a medium. */
    static double index(Surface medium) {
        return medium == null ? 1 : NaiveMedium.boundary(medium.material).indexOfRefraction();
    }

    /** Origin and unit direction of the ray through a place of the picture, 0..1 from its upper left corner. */
    Vec3[] ray(double x, double y) {
        if (scene.camera() instanceof Camera.Window w) {
            Vec3 corner = NaiveShape.at(w.upperLeft());
            Vec3 p = corner.plus(NaiveShape.at(w.upperRight()).minus(corner).times(x))
                    .plus(NaiveShape.at(w.lowerLeft()).minus(corner).times(y));
            return new Vec3[] {p, p.minus(NaiveShape.at(w.eye())).normalized()};
        }
        Camera.Perspective c = (Camera.Perspective) scene.camera();
        Vec3 eye = NaiveShape.at(c.eye());
        Vec3 forward = NaiveShape.at(c.lookAt()).minus(eye).normalized();
        Vec3 right = c.up().cross(forward).normalized();
        Vec3 up = forward.cross(right);
        double half = Math.tan(Math.toRadians(c.fieldOfView()) / 2);
        double aspect = (double) scene.width() / scene.height();
        Vec3 d = forward.plus(right.times((2 * x - 1) * half * aspect)).plus(up.times((1 - 2 * y) * half));
        return new Vec3[] {eye, d.normalized()};
    }

    /** What fills a point: glass, a medium of a solid, or that of the whole scene. */
    NaiveMedium fills(Vec3 p) {
        Surface s = medium(p);
        return s == null
                ? ((Shading.Physical) scene.shading())
                        .medium()
                        .map(NaiveMedium::of)
                        .orElse(NaiveMedium.EMPTY)
                : NaiveMedium.of(s.material());
    }

    int width() {
        return scene.width();
    }

    int height() {
        return scene.height();
    }
}
