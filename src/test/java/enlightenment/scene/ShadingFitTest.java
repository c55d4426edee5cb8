package enlightenment.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.color.Rgb;
import enlightenment.geometry.Box;
import enlightenment.geometry.Cone;
import enlightenment.geometry.Cube;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.geometry.Torus;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;

class ShadingFitTest {
    private static final Texture WHITE = Texture.of(DisplayRgb.WHITE);
    private static final Material BRASS = Glossy.of(WHITE, 0.5);
    private static final Material SKY = new Material.Matte(WHITE, false);
    private static final Texture HEIGHTS =
            new Texture.File(Path.of("heights.png"), Texture.Filter.BILINEAR, Texture.Encoding.LINEAR);
    private static final Sphere BALL = Sphere.of(ExactPoint.ORIGIN, 1);

    private static Scene.Builder scene(Shading shading) {
        return Scene.builder()
                .camera(new Camera.Isometric(ExactPoint.ORIGIN, 3))
                .shading(shading);
    }

    private static InvalidValueException refused(Scene.Builder scene) {
        return assertThrows(InvalidValueException.class, scene::build);
    }

    @Test
    void aMaterialThatClassicShadingDoesNotKnowIsRefusedWhereItIsUsed() {
        InvalidValueException e = refused(scene(Shading.Classic.DEFAULT)
                .object(BALL, Material.Matte.of(WHITE))
                .object(BALL, BRASS));
        assertEquals("objects/1/material/type", e.key());
        assertTrue(e.problem().startsWith("\"glossy\" needs \"shading\": {\"model\": \"physical\"}"), e.problem());
        scene(Shading.Physical.DEFAULT).object(BALL, BRASS).build();
    }

    @Test
    void aPupilBeyondAllMeasureIsRefusedInPhysicalShadingWhereItIsALens() {
        Camera eye = eye(1001);
        scene(Shading.Classic.DEFAULT).camera(eye).build();
        scene(Shading.Physical.DEFAULT).camera(eye(1000)).build();
        InvalidValueException e = refused(scene(Shading.Physical.DEFAULT).camera(eye));
        assertEquals("camera/pupilRadius", e.key());
        assertTrue(e.problem().startsWith("must be at most 1000 times the distance"), e.problem());
    }

    @Test
    void classicShadingRefusesALens() {
        Camera lens = new Camera.Perspective(ExactPoint.of(0, 0, -5), ExactPoint.ORIGIN, Vec3.Y, 40)
                .withLens(Camera.Lens.round(0.1, 5));
        scene(Shading.Physical.DEFAULT).camera(lens).build();
        InvalidValueException e = refused(scene(Shading.Classic.DEFAULT).camera(lens));
        assertEquals("camera/lens", e.key());
        assertTrue(e.problem().startsWith("needs \"shading\": {\"model\": \"physical\"}"), e.problem());
    }

    @Test
    void aViewFromInfinitelyFarIsRefusedWhereAMediumHasNoEnd() {
        Medium medium = Medium.Coefficients.of(Rgb.BLACK, Rgb.WHITE);
        Shading fog = new Shading.Physical(
                OptionalInt.empty(), new Shading.Background.Constant(Rgb.BLACK), Optional.of(medium));
        InvalidValueException e = refused(scene(fog));
        assertEquals("camera/type", e.key());
        assertTrue(e.problem().startsWith("must not be \"isometric\""), e.problem());
        scene(fog).camera(eye(0)).build();
        scene(Shading.Physical.DEFAULT).build();
    }

    private static Camera eye(double pupilRadius) {
        return new Camera.Window(
                ExactPoint.of(0, 0, -1),
                ExactPoint.of(0, 0, 0),
                ExactPoint.of(0, 1, 0),
                ExactPoint.of(1, 1, 0),
                ExactPoint.of(1, 0, 0),
                pupilRadius);
    }

    @Test
    void aMaterialWithANameIsRefusedAtItsName() {
        assertEquals(
                "materials/door~1handle~0/type",
                refused(scene(Shading.Classic.DEFAULT)
                                .material("door/handle~", BRASS)
                                .object(BALL, BRASS))
                        .key());
    }

    @Test
    void materialsThatNothingUsesDoNoHarm() {
        scene(Shading.Classic.DEFAULT).material("brass", BRASS).build();
        scene(Shading.Physical.DEFAULT).material("sky", SKY).build();
    }

    @Test
    void aPaneIsNeitherRoughNorFilledInPhysicalShading() {
        Material rough = Glass.of(WHITE, 1.5).withRoughness(0.3);
        Material fog = Material.Scattering.of(Medium.Coefficients.of(Rgb.WHITE, Rgb.BLACK));
        Cylinder tube = new Cylinder(ExactPoint.ORIGIN, ExactPoint.of(0, 1, 0), 0.5, false);
        Texture checks = new Texture.Checker(List.of(Rgb.BLACK, Rgb.gray(0.5)), 2);
        Material frosted = Glass.of(WHITE, 1.5).withRoughness(Texture.Amount.of(checks));
        for (Material material : new Material[] {rough, fog, frosted}) {
            InvalidValueException e = refused(
                    scene(Shading.Physical.DEFAULT).object(BALL, material).object(tube, material));
            assertEquals("objects/1/material", e.key());
            assertTrue(e.problem().contains("this shape encloses no volume"), e.problem());
            scene(Shading.Physical.DEFAULT)
                    .object(new Cylinder(tube.base(), tube.top(), tube.radius(), true), material)
                    .build();
        }
        scene(Shading.Classic.DEFAULT).object(tube, rough).build();
        scene(Shading.Physical.DEFAULT).object(tube, Glass.of(WHITE, 1.5)).build();
    }

    @Test
    void surfacesWithoutShadowsAreRefusedInPhysicalShading() {
        scene(Shading.Classic.DEFAULT).object(BALL, SKY).build();
        InvalidValueException e = refused(scene(Shading.Physical.DEFAULT).object(BALL, SKY));
        assertEquals("objects/0/material/receivesShadows", e.key());
        assertEquals(
                "must be true in physical shading: what stands in the way of light takes it from every surface alike",
                e.problem());
    }

    @Test
    void facesAreLookedAtToo() {
        Cube cube = new Cube(ExactPoint.ORIGIN, 1, Vec3.ZERO);
        Material white = Material.Matte.of(WHITE);
        SceneObject object = new SceneObject("", cube, white, List.of(white, white, white, SKY, white, white));
        assertEquals(
                "objects/0/faces/3/receivesShadows",
                refused(scene(Shading.Physical.DEFAULT).object(object)).key());
    }

    @Test
    void reliefIsRefusedWhereDirectionsOfTexturesAreUnknown() {
        Material normals = new Composite.NormalMap(Material.Matte.of(WHITE), Texture.of(new Rgb(0.5, 0.5, 1)));
        Material bump = new Composite.Bump(Material.Matte.of(WHITE), HEIGHTS, 0.5);
        Material inside = new Composite.Mix(BRASS, new Composite.Mask(bump, WHITE), WHITE);
        Cube cube = new Cube(ExactPoint.ORIGIN, 1, Vec3.ZERO);
        List<Shape> unknown = List.of(
                new Disk(ExactPoint.ORIGIN, Vec3.Y, 1),
                new Cylinder(ExactPoint.ORIGIN, ExactPoint.of(0, 1, 0), 0.5, true),
                new Cone(ExactPoint.ORIGIN, ExactPoint.of(0, 1, 0), 0.5, 0, true),
                new Torus(ExactPoint.ORIGIN, Vec3.Y, 2, 1),
                new Box(ExactPoint.ORIGIN, ExactPoint.of(1, 1, 1)),
                cube);
        for (Material material : List.of(normals, bump, inside)) {
            for (Shape shape : unknown) {
                InvalidValueException e = refused(
                        scene(Shading.Physical.DEFAULT).object(BALL, material).object(shape, material));
                assertEquals("objects/1/material", e.key());
                assertTrue(
                        e.problem()
                                .startsWith("normal maps and bumps need a mesh, a rectangle, a triangle or a sphere"),
                        e.problem());
            }
        }
        SceneObject faces = new SceneObject("", cube, BRASS, List.of(BRASS, BRASS, inside, BRASS, BRASS, BRASS));
        assertEquals(
                "objects/0/faces/2",
                refused(scene(Shading.Physical.DEFAULT).object(faces)).key());
        Material holes = new Composite.Mask(BRASS, WHITE);
        unknown.forEach(
                shape -> scene(Shading.Physical.DEFAULT).object(shape, holes).build());
    }

    @Test
    void whatWouldTurnNoNormalIsNoMap() {
        Material white = Material.Matte.of(WHITE);
        Texture checks = new Texture.Checker(List.of(DisplayRgb.WHITE, DisplayRgb.BLACK), 2);
        for (Texture map : List.of(WHITE, checks)) {
            InvalidValueException e =
                    assertThrows(InvalidValueException.class, () -> new Composite.Bump(white, map, 1));
            assertEquals("map", e.key());
            assertEquals("must be a texture that is a file: no other has slopes", e.problem());
        }
        Texture colors = new Texture.File(Path.of("n.png"), Texture.Filter.BILINEAR, Texture.Encoding.SRGB);
        InvalidValueException e =
                assertThrows(InvalidValueException.class, () -> new Composite.NormalMap(white, colors));
        assertEquals("map", e.key());
        assertTrue(e.problem().startsWith("must be a texture with \"encoding\": \"linear\""), e.problem());
    }

    @Test
    void partsOfMaterialsAreLookedAtToo() {
        InvalidValueException e =
                refused(scene(Shading.Physical.DEFAULT).object(BALL, new Composite.Mix(BRASS, SKY, WHITE)));
        assertEquals("objects/0/material/materials/1/receivesShadows", e.key());
        assertEquals(
                "objects/0/material/type",
                refused(scene(Shading.Classic.DEFAULT)
                                .object(BALL, new Composite.Mask(Material.Matte.of(WHITE), WHITE)))
                        .key());
    }

    @Test
    void allPlacesAreToldAtOnceButNotThousands() {
        Scene.Builder scene = scene(Shading.Classic.DEFAULT);
        Collections.nCopies(1000, BRASS).forEach(m -> scene.object(BALL, m));
        String problem = refused(scene).problem();
        assertTrue(
                problem.endsWith("; the same at /objects/1/material/type, /objects/2/material/type,"
                        + " /objects/3/material/type and 996 more"),
                problem);
    }
}
