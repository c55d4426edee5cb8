package enlightenment.world;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Rectangle;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.geometry.Transform;
import enlightenment.geometry.Triangle;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Coated;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.mesh.TriangleMesh;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * One example of every kind of shape, light, camera, material and texture, and the check that there is one of every kind: a
 * new kind fails the tests that use these until it has an example, and then until everything handles it.
 */
public final class Descriptions {
    private static final Texture RED = Texture.of(new DisplayRgb(1, 0.25, 0.125));

    private static final TriangleMesh TETRAHEDRON = TriangleMesh.of(
            new float[] {0.5f, 0.5f, 0.5f, 0.5f, -0.5f, -0.5f, -0.5f, 0.5f, -0.5f, -0.5f, -0.5f, 0.5f},
            new int[] {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2});

    /** Shapes around (0, 0, 4), about 1 large, that a ray along +z from the origin meets. */
    public static final List<Shape> SHAPES = all(
            Shape.class,
            List.<Shape>of(
                    Sphere.of(ExactPoint.of(0, 0, 4), 1),
                    new Rectangle(
                            ExactPoint.of(-1, -1, 4),
                            ExactPoint.of(-1, 1, 4),
                            ExactPoint.of(1, 1, 4),
                            ExactPoint.of(1, -1, 4)),
                    new Disk(ExactPoint.of(0, 0, 4), new Vec3(0, 0, -1), 1),
                    new Cylinder(ExactPoint.of(0, -1, 4), ExactPoint.of(0, 1, 4), 0.5, true),
                    new Cone(ExactPoint.of(0, -1, 4), ExactPoint.of(0, 1, 4), 1, 0, true),
                    new Cube(ExactPoint.of(0, 0, 4), 1, new Vec3(10, 20, 30)),
                    new Box(ExactPoint.of(-1, -1, 3.5), ExactPoint.of(1, 1, 4.5)),
                    new Torus(ExactPoint.of(0.75, 0, 4), Vec3.Y, 0.75, 0.25),
                    new Triangle(ExactPoint.of(-1, -1, 4), ExactPoint.of(0, 1, 4), ExactPoint.of(1, -1, 4)),
                    Mesh.of(
                            TETRAHEDRON,
                            Transform.of(
                                    new Transform.Rotate(new Vec3(10, 20, 30)),
                                    new Transform.Scale(new Vec3(1, 1.25, 0.75)),
                                    new Transform.Translate(ExactPoint.of(0, 0, 4))))));

    /** Lights around (0, 0, 4). */
    public static final List<Light> LIGHTS = all(
            Light.class,
            List.<Light>of(
                    new Light.Sphere(ExactPoint.of(0, 0, 4), 1, DisplayRgb.WHITE),
                    new Light.Rectangle(
                            ExactPoint.of(-1, -1, 4),
                            ExactPoint.of(-1, 1, 5),
                            ExactPoint.of(1, 1, 5),
                            ExactPoint.of(1, -1, 4),
                            DisplayRgb.WHITE),
                    new Light.Point(ExactPoint.of(0, 0, 4), DisplayRgb.WHITE),
                    new Light.Spot(
                            ExactPoint.of(0, 0, 4), new Vec3(0, 0, -2), 30, 20, DisplayRgb.WHITE, Emission.INTENSITY_1),
                    new Light.Projector(
                            ExactPoint.of(0, 0, 4),
                            new Texture.File(Path.of("picture.png"), Texture.Filter.BILINEAR, Texture.Encoding.SRGB),
                            new Vec3(0, 0, -2),
                            Vec3.Y,
                            30,
                            DisplayRgb.WHITE,
                            Emission.INTENSITY_1),
                    new Light.Ies(
                            ExactPoint.of(0, 0, 4),
                            Path.of("lamp.ies"),
                            new Vec3(0, 0, -2),
                            30,
                            DisplayRgb.WHITE,
                            Emission.INTENSITY_1),
                    new Light.Distant(new Vec3(0, 0, -2), 2, DisplayRgb.WHITE, Emission.IRRADIANCE_1)));

    /** Cameras that look at (0, 0, 4). */
    public static final List<Camera> CAMERAS = all(
            Camera.class,
            List.<Camera>of(
                    new Camera.Window(
                            ExactPoint.of(0, 0, -1),
                            ExactPoint.of(-1, -1, 0),
                            ExactPoint.of(-1, 1, 0),
                            ExactPoint.of(1, 1, 0),
                            ExactPoint.of(1, -1, 0),
                            0.5),
                    new Camera.Perspective(ExactPoint.ORIGIN, ExactPoint.of(0, 0, 4), Vec3.Y, 60),
                    new Camera.Orthographic(ExactPoint.ORIGIN, ExactPoint.of(0, 0, 4), Vec3.Y, 3),
                    new Camera.Isometric(ExactPoint.of(0, 0, 4), 3),
                    new Camera.Panorama(ExactPoint.ORIGIN, ExactPoint.of(0, 0, 4), Vec3.Y)));

    /** Materials of one colour. */
    public static final List<Material> MATERIALS = all(
            Material.class,
            List.of(
                    Material.Matte.of(RED),
                    Material.Mirror.of(RED),
                    Glossy.of(RED, 0.5),
                    Coated.of(RED, 0.5),
                    Principled.of(RED, 0.25, 0.5),
                    Glass.of(RED, 1.5),
                    Material.Scattering.of(Medium.Colored.of(Rgb.gray(0.5), Rgb.gray(0.25))),
                    new Material.Fluorescent(
                            RED, new Material.WavelengthBand(300, 400), new Material.WavelengthBand(500, 600), 0.5),
                    new Composite.Mix(Material.Matte.of(RED), Material.Mirror.of(RED), Texture.of(Rgb.gray(0.5))),
                    new Composite.Mask(Material.Matte.of(RED), Texture.of(Rgb.gray(0.5))),
                    new Composite.NormalMap(Material.Matte.of(RED), Texture.of(new Rgb(0.5, 0.25, 1))),
                    new Composite.Bump(
                            Material.Matte.of(RED),
                            new Texture.File(Path.of("texture.png"), Texture.Filter.BILINEAR, Texture.Encoding.LINEAR),
                            0.5)));

    /** Those that classic shading knows. */
    public static final List<Material> CLASSIC_MATERIALS = MATERIALS.stream()
            .filter(m -> m instanceof Material.Matte || m instanceof Material.Mirror || m instanceof Glass)
            .toList();

    /** Textures; no file is where the one names it. */
    public static final List<Texture> TEXTURES = all(
            Texture.class,
            List.<Texture>of(
                    RED,
                    new Texture.Checker(List.of(DisplayRgb.WHITE, DisplayRgb.BLACK), 2),
                    new Texture.File(Path.of("texture.png"), Texture.Filter.BILINEAR, Texture.Encoding.SRGB)));

    private Descriptions() {}

    /** The concrete classes of a sealed family. */
    public static Stream<Class<?>> kinds(Class<?> family) {
        return family.isSealed()
                ? Arrays.stream(family.getPermittedSubclasses()).flatMap(Descriptions::kinds)
                : Stream.of(family);
    }

    private static <T> List<T> all(Class<T> family, List<T> examples) {
        Set<Class<?>> missing = kinds(family).collect(Collectors.toSet());
        for (T example : examples) {
            missing.remove(example.getClass());
        }
        if (!missing.isEmpty()) {
            throw new AssertionError("no example of " + missing);
        }
        return examples;
    }
}
