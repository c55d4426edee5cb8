package enlightenment.physical;

import static enlightenment.physical.PhysicalScenes.at;
import static enlightenment.physical.PhysicalScenes.ball;
import static enlightenment.physical.PhysicalScenes.linear;
import static enlightenment.physical.PhysicalScenes.matte;
import static enlightenment.physical.PhysicalScenes.shading;
import static enlightenment.physical.PhysicalScenes.sphereLight;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Triangle;
import enlightenment.image.Image;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.Vec3;
import enlightenment.render.TestScenes;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.List;

/** Scenes of which every place of the picture has a radiance that is known. */
final class ClosedForms {
    private ClosedForms() {}

    /**
     * A scene and its light.
     *
     * @param radiance of every pixel, in each band
     */
    record Known(String name, Scene scene, double... radiance) {
        @Override
        public String toString() {
            return name;
        }

        /**
         * Fails unless the picture shows the light: six standard errors of twelve means, a chance of 1e-4 to fail by Student's
         * distribution.
         */
        void assertShown(RenderSettings settings) {
            List<Image> pictures = Rendered.seeds(scene, settings, 1, 12);
            for (int band = 0; band < radiance.length; band++) {
                Statistics s = Statistics.of(Rendered.means(pictures, 0, 0, scene.width(), scene.height(), band));
                double expected = radiance[band];
                // A pixel is a float; rays are not exactly perpendicular; a table of albedos closes to about 1e-3.
                double tolerance =
                        6 * s.error() + 1e-6 * expected + (name.matches(".*(metal|frosted|roughest).*") ? 2e-3 : 0);
                assertTrue(Math.abs(s.mean() - expected) <= tolerance, () -> s + " instead of " + expected);
            }
        }
    }

    private static Scene.Builder inside(double x, double y, double z) {
        return Scene.builder()
                .size(8, 8)
                .camera(new Camera.Perspective(at(x, y, z), at(0.1, 0.2, 1), Vec3.Y, 30))
                .shading(shading(0));
    }

    /** A lamp of radius r in the middle of a ball of radius 1 (the integrating sphere): all of the wall is equally bright. */
    static Known integratingSphere(double r, double reflectance) {
        double share = r * r;
        double wall = reflectance * share / (1 - reflectance * (1 - share));
        Scene scene = inside(0.3, 0.2, 0.7)
                .object(ball(0, 0, 0, 1), matte(reflectance, reflectance / 2, 0))
                .light(sphereLight(0, 0, 0, r, 1))
                .camera(new Camera.Perspective(at(0.3, 0.2, 0.7), at(0.5, 0.4, 1.5), Vec3.Y, 30))
                .build();
        double other = reflectance / 2 * share / (1 - reflectance / 2 * (1 - share));
        return new Known("integrating sphere, lamp " + r + ", reflectance " + reflectance, scene, wall, other, 0);
    }

    /** Walls that glow and reflect all over: Le + ρ Le + ρ² Le + … */
    static Known glowingBall(double reflectance) {
        Material wall = matte(reflectance, reflectance, reflectance).withRadiance(new Rgb(1, 0.5, 0.25));
        double sum = 1 / (1 - reflectance);
        return new Known(
                "glowing ball, reflectance " + reflectance,
                inside(0.3, 0.2, -0.1).object(ball(0, 0, 0, 1), wall).build(),
                sum,
                sum / 2,
                sum / 4);
    }

    /** The same in a box, where form factors differ from place to place. */
    static Known glowingBox(double reflectance) {
        Material wall = matte(reflectance, reflectance, reflectance).withRadiance(Rgb.gray(0.5));
        double sum = 0.5 / (1 - reflectance);
        return new Known(
                "glowing box, reflectance " + reflectance,
                inside(0.3, 0.2, -0.1)
                        .object(new Box(at(-1, -0.5, -0.7), at(1.2, 0.8, 1.5)), wall)
                        .build(),
                sum,
                sum,
                sum);
    }

    /** What loses no light cannot be seen where the same light comes from everywhere; nor can two such things behind each other. */
    static Known furnace(String name, Shape shape, Material material) {
        Scene scene = PhysicalScenes.view(8, 8)
                .shading(shading(0.5))
                .object(shape, material)
                .object(ball(0.3, 1.4, 0.9, 0.5), Material.Mirror.of(linear(1, 1, 1)))
                .build();
        return new Known("furnace, " + name, scene, 0.5, 0.5, 0.5);
    }

    private static Material glass(double index, double roughness) {
        return Glass.of(linear(1, 1, 1), index).withRoughness(roughness);
    }

    static List<Known> furnaces() {
        Material glass = Glass.of(linear(1, 1, 1), 1.5);
        Shape ball = ball(-0.2, 0.9, 0, 0.7);
        return List.of(
                furnace("mirror", ball, Material.Mirror.of(linear(1, 1, 1))),
                furnace("glass", ball, glass),
                furnace("glass box", new Box(at(-0.6, 0.5, -0.5), at(0.5, 1.6, 0.2)), glass),
                furnace("diamond", ball, Glass.of(linear(1, 1, 1), 2.4)),
                furnace("bubble", ball, Glass.of(linear(1, 1, 1), 0.7)),
                furnace(
                        "pane",
                        TestScenes.rectangle(-0.5, 0.4, 0.3, -0.6, 1.7, 0, 0.6, 1.7, -0.2, 0.7, 0.4, 0.1),
                        glass),
                furnace("matte", ball, matte(1, 1, 1)),
                furnace("rough matte", ball, matte(1, 1, 1).withRoughness(0.8)),
                furnace("rough metal", ball, Glossy.of(linear(1, 1, 1), 0.7)),
                furnace("frosted glass", ball, glass(1.5, 0.7)),
                furnace("the roughest glass", new Box(at(-0.6, 0.5, -0.5), at(0.5, 1.6, 0.2)), glass(2.4, 1)),
                furnace("half glass", ball, new Glass(linear(1, 1, 1), 1.5, 0.4, 0, true)));
    }

    /** Two parallel faces of glass, lit from behind only, and looked at nearly straight on: (1 − R)/(1 + R) comes through. */
    static Known slab() {
        double r = 0.2 * 0.2;
        double through = (1 - r) / (1 + r);
        Scene scene = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(at(0, 0, -2), at(0, 0, 0), Vec3.Y, 0.5))
                .shading(shading(0))
                .object(new Box(at(-50, -50, -0.1), at(50, 50, 0.2)), Glass.of(linear(1, 1, 1), 1.5))
                .object(
                        TestScenes.rectangle(-50, -50, 1, -50, 50, 1, 50, 50, 1, 50, -50, 1),
                        matte(0, 0, 0).withRadiance(new Rgb(1, 2, 3)))
                .build();
        return new Known("slab", scene, through, 2 * through, 3 * through);
    }

    private static final Material WATER = Glass.of(linear(1, 1, 1), 4.0 / 3);

    /** What the faces of a pane of index 2 in water reflect straight on, as glass of index 3/2 does in empty space. */
    private static final double FACE_IN_WATER = 0.2 * 0.2;

    private static final double THROUGH_PANE_IN_WATER = (1 - FACE_IN_WATER) / (1 + FACE_IN_WATER);

    private static Scene.Builder inWater(double degrees) {
        return Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(at(0, 0, -2), at(0, 0, 0), Vec3.Y, degrees))
                .object(new Box(at(-60, -60, -10), at(60, 60, 10)), WATER);
    }

    private static Shape across(double z) {
        return TestScenes.rectangle(-50, -50, z, -50, 50, z, 50, 50, z, 50, -50, z);
    }

    /** A pane in water, before something that glows; what it reflects is black. */
    static Known paneInWater() {
        Scene scene = inWater(0.5)
                .shading(shading(0))
                .object(across(-3), matte(0, 0, 0))
                .object(across(-0.5), Glass.of(linear(1, 0.5, 1), 2))
                .object(across(1), matte(0, 0, 0).withRadiance(new Rgb(1, 2, 3)))
                .build();
        double through = THROUGH_PANE_IN_WATER;
        return new Known("pane in water", scene, through, through, 3 * through);
    }

    /** {@link #pointLight} in water, behind a pane. */
    static Known pointLightInWater() {
        Scene scene = inWater(0.02)
                .shading(PhysicalScenes.atMost(1, 0))
                .object(across(0), matte(0.5, 0.5, 0.5))
                .object(across(-2.5), Glass.of(linear(1, 0.5, 1), 2))
                .light(new Light.Point(at(0, 0, -3), Rgb.WHITE, Emission.power(new Rgb(4 * Math.PI, 8 * Math.PI, 0))))
                .build();
        double one = 0.5 / Math.PI / 9 * THROUGH_PANE_IN_WATER;
        return new Known("point light behind a pane in water", scene, one, one, 0);
    }

    /** The eye within glass: what comes in is brighter by the square of the index. */
    static Known withinGlass() {
        double n = 1.5;
        double r = 0.04;
        double factor = n * n * (1 - r) * Math.exp(-0.3) * 0.5;
        Scene scene = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(at(0, 0, 0), at(0, 0, 1), Vec3.Y, 0.5))
                .shading(shading(0))
                .object(ball(0, 0, 0, 1), Glass.of(linear(1, 1, 1), n).withAbsorption(new Rgb(0.3, 0.6, 0)))
                .object(
                        TestScenes.rectangle(-1, -1, 2, -1, 1, 2, 1, 1, 2, 1, -1, 2),
                        matte(0, 0, 0).withRadiance(Rgb.gray(0.5)))
                .build();
        // What is reflected inside comes to the other side, where all is black, and back: R² and less of light that was
        // absorbed.
        return new Known(
                "eye in glass",
                scene,
                factor * series(r, 0.3),
                factor * Math.exp(-0.3) * series(r, 0.6),
                factor * Math.exp(0.3) * series(r, 0));
    }

    /** Light that is reflected at both ends of a diameter of 2 comes again: 1 + (R e^(−2σ))² + … */
    private static double series(double r, double absorption) {
        double round = r * Math.exp(-2 * absorption);
        return 1 / (1 - round * round);
    }

    /** A wall that glows, and a checkered albedo: the irradiance within a ball is the same everywhere. */
    static Known checkered() {
        Material wall = new Material.Matte(
                new Texture.Checker(List.of(new Rgb(0.9, 0.9, 0.9), new Rgb(0.1, 0.1, 0.1)), 8),
                true,
                0,
                Rgb.gray(0.25));
        Scene scene = Scene.builder()
                .size(4, 4)
                // The middle of the square with u in (0, 1/8) and v in (3/8, 1/2): the odd column of the fourth row.
                .camera(new Camera.Perspective(at(0, 0, 0), at(Math.sin(0.39), 0.2, -Math.cos(0.39)), Vec3.Y, 8))
                .shading(shading(0))
                .object(ball(0, 0, 0, 1), wall)
                .build();
        double radiance = 0.25 * (1 + 0.1 / (1 - 0.5));
        return new Known("checkered ball", scene, radiance, radiance, radiance);
    }

    /** A matte wall right before a light without extent: I·ρ/(π d²). */
    static Known pointLight() {
        Scene scene = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(at(0, 0, -2), at(0, 0, 0), Vec3.Y, 0.02))
                .shading(shading(0))
                .object(TestScenes.rectangle(-1, -1, 0, -1, 1, 0, 1, 1, 0, 1, -1, 0), matte(0.5, 0.5, 0.5))
                .light(new Light.Point(at(0, 0, -3), Rgb.WHITE, Emission.power(new Rgb(4 * Math.PI, 8 * Math.PI, 0))))
                .build();
        double one = 0.5 / Math.PI / 9;
        return new Known("point light", scene, one, 2 * one, 0);
    }

    /** Emission seen directly. */
    static Known seen() {
        Scene scene = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(at(0, 0, -2), at(0, 0, 0), Vec3.Y, 5))
                .shading(shading(9))
                .light(new Light.Sphere(
                        at(0, 0, 0), 0.5, new Rgb(1, 0.5, 0), Emission.power(Rgb.gray(Math.PI * Math.PI))))
                .build();
        return new Known("a lamp", scene, 1, 0.5, 0);
    }

    /** Walls of any closed form that glow and reflect all over: no form factor matters. */
    static Known glowingInside(String name, Shape shape) {
        Material wall = matte(0.6, 0.3, 0).withRadiance(new Rgb(1, 2, 3));
        Scene scene = inside(0.3, 0.1, -0.1).object(shape, wall).build();
        return new Known("glowing " + name, scene, 1 / (1 - 0.6), 2 / (1 - 0.3), 3);
    }

    /** Forms around the place of {@link #inside}. */
    static List<Known> insides() {
        return List.of(
                glowingInside("cylinder", new Cylinder(at(-0.2, -0.5, -0.6), at(0.6, 0.9, 0.7), 0.8, true)),
                glowingInside("cone", new Cone(at(0.2, -0.9, 0), at(0.4, 2, 0.1), 1.1, 0, true)),
                glowingInside("frustum", new Cone(at(0.2, -0.9, 0), at(0.4, 1, 0.1), 1.1, 0.4, true)),
                glowingInside("cube", new Cube(at(0.1, 0, 0.1), 1.3, new Vec3(20, 30, 40))),
                glowingInside("ring", new Torus(at(-0.6, 0, 0), new Vec3(0.1, 1, 0), 0.9, 0.4)));
    }

    /** Two mirrors that face each other, of which one glows: Le + ρ² Le + … */
    static Known mirrors() {
        Material glow = new Material.Mirror(linear(0.9, 0.5, 0), true, new Rgb(1, 2, 3));
        Scene scene = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(at(0, 0, 0), at(0, 0, 1), Vec3.Y, 0.01))
                .shading(shading(7))
                .object(TestScenes.rectangle(-50, -50, 1, -50, 50, 1, 50, 50, 1, 50, -50, 1), glow)
                .object(
                        TestScenes.rectangle(-50, -50, -1, -50, 50, -1, 50, 50, -1, 50, -50, -1),
                        Material.Mirror.of(linear(0.9, 0.5, 0)))
                .build();
        return new Known("mirrors", scene, 1 / (1 - 0.81), 2 / (1 - 0.25), 3);
    }

    /** What is flat sees nothing of its own light, however it lies. */
    static Known sheet(Shape shape) {
        Scene scene = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(at(0.5, 0.4, -2), at(0, 0, 0), Vec3.Y, 5))
                .shading(shading(0))
                .object(shape, matte(0.8, 0.5, 0.3).withRadiance(new Rgb(1, 2, 3)))
                .build();
        return new Known("glowing " + shape.type(), scene, 1, 2, 3);
    }

    static List<Known> sheets() {
        return List.of(
                sheet(TestScenes.rectangle(-1.1, -0.9, 0.3, -0.8, 1.1, 0.7, 1.1, 0.9, -0.3, 0.8, -1.1, -0.7)),
                sheet(new Disk(at(0.1, 0.03, 0), new Vec3(0.3, 0.4, -1), 1)),
                sheet(new Triangle(at(-1.3, -1.1, 0.6), at(0.1, 2, 0.3), at(1.2, -0.9, -0.5))),
                sheet(new Cube(at(0, 0, 1), 1.5, new Vec3(10, 20, 30))),
                sheet(ball(0, 0, 0.5, 0.7)));
    }

    /** A matte floor under a sphere light, which the horizon cuts or not. */
    static Known floor(double distance, double cosine) {
        double sine = Math.sqrt(1 - cosine * cosine);
        double irradiance = irradiance(distance, cosine);
        Scene scene = Scene.builder()
                .size(4, 4)
                .camera(new Camera.Perspective(at(0, 1e-4, -1e-4), at(0, 0, 0), Vec3.Y, 1e-3))
                .shading(PhysicalScenes.atMost(1, 0))
                .object(TestScenes.rectangle(-1, 0, -1, -1, 0, 1, 1, 0, 1, 1, 0, -1), matte(0.5, 0.25, 0))
                .light(new Light.Sphere(
                        at(10 * distance * sine, 10 * distance * cosine, 0),
                        10,
                        Rgb.WHITE,
                        Emission.radiance(Rgb.gray(Math.PI / irradiance))))
                .build();
        return new Known("floor " + distance + " radii under a lamp, cosine " + cosine, scene, 0.5, 0.25, 0);
    }

    /** Of a ball of radius and radiance 1: J. Snyder, "Area light sources for real-time graphics" (1996). */
    private static double irradiance(double h, double cosine) {
        if (cosine >= 1 / h) {
            return Math.PI * cosine / (h * h);
        }
        double sine = Math.sqrt(1 - cosine * cosine);
        double x = Math.sqrt(h * h - 1);
        double y = -x * cosine / sine;
        double q = sine * Math.sqrt(1 - y * y);
        return (cosine * Math.acos(y) - x * q) / (h * h) + Math.atan(q / x);
    }

    /** From nearly touching to as far as stars; the floor is bounded, so that a lamp may reach below the horizon. */
    static List<Known> floors() {
        double[][] places = {
            {2, 0.2}, {2, 0}, {2, -0.3}, {1.1, 0.5}, {5, 0.1}, {5, -0.15}, {2, 0.6}, {1e3, 0.6}, {1e8, 0.3}
        };
        List<Known> all = new ArrayList<>();
        for (double[] place : places) {
            all.add(floor(place[0], place[1]));
        }
        all.add(floor(1e12, 0.9));
        return all;
    }

    static List<Known> all() {
        List<Known> all = new ArrayList<>(furnaces());
        all.add(integratingSphere(0.5, 0.8));
        all.add(glowingBall(0.5));
        all.add(glowingBall(0.9));
        all.add(glowingBox(0.8));
        all.add(slab());
        all.add(paneInWater());
        all.add(pointLightInWater());
        all.add(withinGlass());
        all.add(checkered());
        all.add(pointLight());
        all.add(seen());
        all.add(mirrors());
        return all;
    }

    /** What the naive tracer cannot do: small lights, other forms, walls that reflect nearly all. */
    static List<Known> hard() {
        List<Known> all = new ArrayList<>(insides());
        all.addAll(floors());
        all.addAll(sheets());
        all.add(integratingSphere(0.15, 0.9));
        all.add(integratingSphere(0.01, 0.5));
        all.add(glowingBall(0.99));
        all.add(glowingBox(0.99));
        return all;
    }
}
