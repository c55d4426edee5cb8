package enlightenment.world.light;

import enlightenment.check.Radiance;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.emitter.IntensityProfile;
import enlightenment.emitter.PictureProfile;
import enlightenment.emitter.SpotProfile;
import enlightenment.emitter.TableProfile;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import enlightenment.numeric.Scale;
import enlightenment.photometry.IntensityTable;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.SceneException.Problem;
import enlightenment.scene.SceneObject;
import enlightenment.world.material.PhysicalSurface;
import enlightenment.world.material.SurfaceMaterial;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;

/**
 * The lights of a scene of physical shading: those with extent become objects with a black emitting surface, the others points; without the
 * distant ones, which belong to the surroundings ({@link CompiledSurroundings}).
 */
public final class GlowingObjects {
    private static final String ULTRAVIOLET = "ultraviolet";

    private final Scene scene;
    private final SceneImages files;

    /** The objects of the scene, then those of lights with extent. */
    public final List<SceneObject> objects;

    /** By material, the surfaces of the lights' objects. */
    public final Map<Material, SurfaceMaterial> surfaces = new IdentityHashMap<>();

    /** The lights without extent, in an order that does not depend on that in the scene. */
    public final List<PhysicalLight> points = new ArrayList<>();

    /**
     * Makes the lights of a scene.
     *
     * @param files reads the files of lights; null to leave out lights with files
     * @throws SceneException with all lights whose radiance is too large for their size or that of the scene, or whose file cannot be used
     */
    public GlowingObjects(Scene scene, SceneFrame frame, SceneImages files) {
        this.scene = scene;
        this.files = files;
        List<SceneObject> all = new ArrayList<>();
        List<Problem> problems = new ArrayList<>();
        for (int i = 0; i < scene.lights().size(); i++) {
            try {
                add(scene.lights().get(i), i, frame, all);
            } catch (InvalidValueException e) {
                problems.addAll(SceneException.of(e).problems());
            } catch (SceneException e) {
                problems.addAll(e.problems());
            }
        }
        if (!problems.isEmpty()) {
            throw new SceneException(problems);
        }
        points.sort(Comparator.<PhysicalLight>comparingDouble(l -> l.x)
                .thenComparingDouble(l -> l.y)
                .thenComparingDouble(l -> l.z)
                .thenComparingDouble(l -> l.r)
                .thenComparingDouble(l -> l.g)
                .thenComparingDouble(l -> l.b)
                .thenComparingDouble(l -> l.ultraviolet)
                .thenComparing(GlowingObjects::parameters, Arrays::compare));
        if (all.isEmpty()) {
            objects = scene.objects();
        } else {
            all.addAll(0, scene.objects());
            objects = Collections.unmodifiableList(all);
        }
    }

    /**
     * Adds a light.
     *
     * @param all receives an object if the light has extent
     */
    private void add(Light light, int i, SceneFrame frame, List<SceneObject> all) {
        if (light instanceof Light.Sphere s) {
            double perPower = 1 / (4 * Math.PI * Math.PI) / s.radius() / s.radius();
            all.add(object(light, i, perPower, true, Sphere.of(s.center(), s.radius())));
        } else if (light instanceof Light.Rectangle q) {
            checkArea(q, i, frame);
            Shape shape = new Rectangle(q.lowerLeft(), q.upperLeft(), q.upperRight(), q.lowerRight());
            double sides = q.twoSided() ? 2 : 1;
            all.add(object(light, i, 1 / (sides * Math.PI * area(q)), q.twoSided(), shape));
        } else if (light instanceof Light.Point p) {
            add(point(p, null, 1 / (4 * Math.PI), 1, i, frame));
        } else if (light instanceof Light.Spot s) {
            SpotProfile profile = new SpotProfile(s.direction().normalized(), s.angle(), s.innerAngle());
            add(point(s, profile, 1 / profile.solidAngle(), 1, i, frame));
        } else if (light instanceof Light.Ies s) {
            addLuminaire(s, i, frame);
        } else if (light instanceof Light.Projector s) {
            addProjector(s, i, frame);
        } else if (!(light instanceof Light.Distant)) {
            throw new AssertionError("no physical form of the light " + light.type());
        }
    }

    private void addLuminaire(Light.Ies light, int i, SceneFrame frame) {
        IntensityTable table = files == null ? null : files.of(light, i);
        if (table != null && table.largest() > 0) {
            TableProfile profile = new TableProfile(table, light.direction().normalized(), light.rotation());
            // The profile is relative to the largest candela.
            add(point(light, profile, 1 / profile.solidAngle(), table.largest(), i, frame));
        }
    }

    private void addProjector(Light.Projector light, int i, SceneFrame frame) {
        if (files == null) {
            return;
        }
        Vec3 axis = light.direction().normalized();
        Vec3 across = light.up().normalized().cross(axis).normalized();
        Projection picture = Projection.of(light.picture(), files.of(light.picture(), true, scene));
        PictureProfile profile = new PictureProfile(picture, axis, axis.cross(across), light.fieldOfView());
        if (profile.solidAngle() > 0) {
            add(point(light, profile, 1 / profile.solidAngle(), 1, i, frame));
        }
    }

    private void add(PhysicalLight point) {
        if (point.luminance() > 0 || point.ultraviolet > 0) {
            points.add(point);
        }
    }

    private static double[] parameters(PhysicalLight point) {
        return point.profile == null ? new double[0] : point.profile.parameters();
    }

    /**
     * @param perPower the radiance of one unit of power
     */
    private SceneObject object(Light light, int index, double perPower, boolean isTwoSided, Shape shape) {
        Rgb radiance = light.emitted();
        double ultraviolet = light.ultraviolet();
        if (light.emission().quantity() == Emission.Quantity.POWER) {
            ultraviolet = bounded(product(ultraviolet, perPower), light, index, ULTRAVIOLET);
            String key = light.emission().quantity().key();
            radiance = new Rgb(
                    bounded(product(radiance.r(), perPower), light, index, key),
                    bounded(product(radiance.g(), perPower), light, index, key),
                    bounded(product(radiance.b(), perPower), light, index, key));
        }
        Material black = Material.Matte.of(Texture.of(DisplayRgb.BLACK));
        surfaces.put(black, new SurfaceMaterial(black, null, PhysicalSurface.light(radiance, ultraviolet, isTwoSided)));
        return SceneObject.of(shape, black);
    }

    /**
     * Refuses a rectangle whose corners are the same doubles in the frame, which cannot be sampled. Given by power its light would be lost;
     * given by radiance there is none worth mentioning.
     *
     * @throws InvalidValueException if it is that small and has power
     */
    private static void checkArea(Light.Rectangle q, int index, SceneFrame frame) {
        Vec3 corner = frame.toFrame(q.lowerLeft());
        Vec3 up = frame.toFrame(q.upperLeft()).minus(corner);
        Vec3 right = frame.toFrame(q.lowerRight()).minus(corner);
        Emission.Quantity quantity = q.emission().quantity();
        // Beside a very distant object a product of edges may underflow although they are distinct: SceneExtent refuses
        // such scenes.
        Vec3 normal = up.scaledBy(-up.exponent()).cross(right.scaledBy(-right.exponent()));
        if (quantity == Emission.Quantity.POWER && normal.maxAbs() == 0) {
            throw new InvalidValueException(
                    "lights/" + index + "/" + quantity.key(),
                    "cannot be that of a rectangle of this size so far from the eye: its corners are one point, or lie in one line, in"
                            + " double precision; a light of type point is the same");
        }
    }

    private static double area(Light.Rectangle q) {
        SceneFrame corner = new SceneFrame(q.lowerLeft(), 0);
        return corner.toFrame(q.upperLeft())
                .cross(corner.toFrame(q.lowerRight()))
                .length();
    }

    /**
     * Makes a point light. Intensity is power per solid angle: in another unit of length, irradiance changes by the square of the unit.
     *
     * @param ofPower the largest intensity of one unit of power
     * @param ofIntensity the largest intensity of one unit of intensity
     */
    private static PhysicalLight point(
            Light p, IntensityProfile profile, double ofPower, double ofIntensity, int index, SceneFrame frame) {
        boolean isPower = p.emission().quantity() == Emission.Quantity.POWER;
        Rgb c = p.emitted();
        double perPower = isPower ? ofPower : ofIntensity;
        Vec3 position = frame.toFrame(p.anchors().get(0));
        String key = p.emission().quantity().key();
        return PhysicalLight.point(
                position,
                profile,
                new Rgb(
                        bounded(intensity(product(c.r(), perPower), frame), p, index, key),
                        bounded(intensity(product(c.g(), perPower), frame), p, index, key),
                        bounded(intensity(product(c.b(), perPower), frame), p, index, key)),
                bounded(intensity(product(p.ultraviolet(), perPower), frame), p, index, ULTRAVIOLET));
    }

    /**
     * Returns a radiance, or an intensity in the frame, if it is within bounds.
     *
     * @param key of the light's quantity in the scene file
     * @throws InvalidValueException if it is beyond {@link Radiance#LARGEST}, at the place of the light
     */
    private static double bounded(double value, Light light, int index, String key) {
        if (!(value <= Radiance.LARGEST)) {
            throw new InvalidValueException(
                    "lights/" + index + "/" + key,
                    !light.hasSurface()
                            ? "is too much for a scene of this size: in units of it, intensity must be at most 1e100"
                            : "is too much for a light of this size: its radiance must be at most 1e100");
        }
        return value;
    }

    /** The product, which is 0 for no power even where a unit of power would be infinite radiance. */
    private static double product(double power, double perPower) {
        return power == 0 ? 0 : power * perPower;
    }

    private static double intensity(double value, SceneFrame frame) {
        return Scale.scalb(Scale.scalb(value, -frame.exponent()), -frame.exponent());
    }
}
