package enlightenment.importer.pbrt;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.geometry.Cylinder;
import enlightenment.geometry.Disk;
import enlightenment.geometry.Mesh;
import enlightenment.geometry.Shape;
import enlightenment.geometry.Sphere;
import enlightenment.importer.SceneImporter;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.material.Coated;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What directives of pbrt become, against descriptions made here. */
class PbrtSceneTest {
    private static final String QUAD = "\"point3 P\" [-1 -1 0 1 -1 0 1 1 0 -1 1 0] \"integer indices\" [0 1 2 0 2 3]";

    @TempDir
    private Path folder;

    private SceneImporter.Result read(String text) throws IOException {
        Path file = folder.resolve("scene.pbrt");
        Files.writeString(file, text);
        return SceneImporter.read(file, SceneImporter.Options.DEFAULT);
    }

    private SceneImporter.Result world(String text) throws IOException {
        return read("WorldBegin\n" + text);
    }

    private Shape shape(String text) throws IOException {
        return world(text).scene().objects().get(0).shape();
    }

    private Material material(String text) throws IOException {
        return world(text + "\nShape \"sphere\"").scene().objects().get(0).material();
    }

    private static Vec3 point(ExactPoint p) {
        return p.toVec3();
    }

    private static void assertNear(Vec3 expected, Vec3 actual) {
        assertTrue(expected.minus(actual).maxAbs() < 1e-9, expected + " is not " + actual);
    }

    @Test
    void aWholeSceneIsEqualToOneMadeByHand() throws IOException {
        Scene scene = read("Film \"rgb\" \"integer xresolution\" 40 \"integer yresolution\" 30\n"
                        + "Integrator \"path\" \"integer maxdepth\" 7\nWorldBegin\n"
                        + "LightSource \"infinite\" \"rgb L\" [.1 .2 .3] \"float scale\" 2\n"
                        + "Material \"diffuse\" \"rgb reflectance\" [.5 .25 .125]\nTranslate 1 2 3\nScale 2 2 2\n"
                        + "Shape \"sphere\" \"float radius\" .5\n")
                .scene();
        Scene expected = Scene.builder()
                .name("scene")
                .size(40, 30)
                .camera(scene.camera())
                .shading(new Shading.Physical(OptionalInt.of(7), new Rgb(0.2, 0.4, 0.6)))
                .object(Sphere.of(ExactPoint.of(1, 2, 3), 1), Material.Matte.of(Texture.of(new Rgb(0.5, 0.25, 0.125))))
                .build();
        assertEquals(expected, scene);
    }

    @Test
    void matricesAreListedColumnByColumn() throws IOException {
        Sphere s = (Sphere) shape("Transform [2 0 0 0  0 2 0 0  0 0 2 0  5 6 7 1] Shape \"sphere\"");
        assertNear(new Vec3(5, 6, 7), point(s.center()));
        assertEquals(2, s.radius(), 1e-12);
        Sphere t = (Sphere) shape("Translate 1 0 0 ConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 9 1] Shape \"sphere\"");
        assertNear(new Vec3(1, 0, 9), point(t.center()));
    }

    @Test
    void transformationsConcernWhatComesLaterFirst() throws IOException {
        Sphere s = (Sphere) shape("Rotate 90 0 0 1 Translate 1 0 0 Shape \"sphere\"");
        assertNear(Vec3.Y, point(s.center()));
    }

    @Test
    void blocksRestoreTheState() throws IOException {
        Scene scene = world("AttributeBegin Translate 1 0 0 Material \"dielectric\" AttributeEnd Shape \"sphere\"")
                .scene();
        assertEquals(ExactPoint.ORIGIN, ((Sphere) scene.objects().get(0).shape()).center());
        assertInstanceOf(Material.Matte.class, scene.objects().get(0).material());
    }

    @Test
    void coordinateSystemsHaveNames() throws IOException {
        Sphere s = (Sphere)
                shape("Translate 4 0 0 CoordinateSystem \"here\" Identity CoordSysTransform \"here\" Shape \"sphere\"");
        assertNear(new Vec3(4, 0, 0), point(s.center()));
        Sphere eye = (Sphere) read("LookAt 1 2 3 0 0 0 0 1 0 Camera \"perspective\" WorldBegin"
                        + " CoordSysTransform \"camera\" Shape \"sphere\"")
                .scene()
                .objects()
                .get(0)
                .shape();
        assertNear(new Vec3(1, 2, 3), point(eye.center()));
    }

    @Test
    void quadricsStayWhatTheyAre() throws IOException {
        Disk d = (Disk) shape("Shape \"disk\" \"float height\" 2 \"float radius\" 3");
        assertNear(new Vec3(0, 0, 2), point(d.center()));
        assertEquals(3, d.radius(), 1e-12);
        Cylinder c = (Cylinder) shape("Shape \"cylinder\" \"float radius\" 2 \"float zmin\" -3 \"float zmax\" 4");
        assertNear(new Vec3(0, 0, -3), point(c.base()));
        assertNear(new Vec3(0, 0, 4), point(c.top()));
    }

    @Test
    void partsOfQuadricsBecomeTrianglesOfTheirArea() throws IOException {
        assertArea(StrictMath.PI * (4 - 1), "Shape \"disk\" \"float radius\" 2 \"float innerradius\" 1");
        assertArea(2 * StrictMath.PI * 2 * 1, "Shape \"sphere\" \"float radius\" 2 \"float zmin\" 1");
        assertArea(StrictMath.PI / 2 * 2, "Shape \"cylinder\" \"float phimax\" 90");
    }

    private void assertArea(double expected, String text) throws IOException {
        assertEquals(expected, area((Mesh) shape(text)), 2e-3 * expected);
        assertEquals(1, world(text).notes().size());
    }

    private static double area(Mesh mesh) {
        double sum = 0;
        for (int t = 0; t < mesh.triangles().triangles(); t++) {
            sum += mesh.triangles().areaNormal(t).length() / 2;
        }
        return sum;
    }

    /** Loop's limit surface of an octahedron touches the axes at (1 − 4γ) of its corners, γ = 1 / (4 + 3/(8 β)), β = 3/32. */
    @Test
    void subdividedVerticesLieOnTheLimitSurface() throws IOException {
        String octahedron =
                "Shape \"loopsubdiv\" \"integer levels\" 2 \"point3 P\" [1 0 0 -1 0 0 0 1 0 0 -1 0 0 0 1 0 0 -1]"
                        + " \"integer indices\" [0 2 4 2 1 4 1 3 4 3 0 4 2 0 5 1 2 5 3 1 5 0 3 5]";
        Mesh mesh = (Mesh) shape(octahedron);
        assertEquals(8 * 16, mesh.triangles().triangles());
        assertTrue(mesh.triangles().isClosed());
        assertEquals(0.5, mesh.triangles().max().x(), 1e-6);
    }

    @Test
    void instancesShareTheirMesh() throws IOException {
        Scene scene = world("ObjectBegin \"o\" Translate 1 0 0 Shape \"trianglemesh\" " + QUAD + " ObjectEnd"
                        + " ObjectInstance \"o\" Scale 2 2 2 ObjectInstance \"o\"")
                .scene();
        Mesh a = (Mesh) scene.objects().get(0).shape();
        Mesh b = (Mesh) scene.objects().get(1).shape();
        assertTrue(a.triangles() == b.triangles());
        assertNear(new Vec3(1, 0, 0), point(a.transform().offset()));
        assertNear(new Vec3(2, 0, 0), point(b.transform().offset()));
    }

    @Test
    void roughnessIsTheFourthRootWhereItIsRemapped() throws IOException {
        Coated c = (Coated) material("Material \"coateddiffuse\" \"float roughness\" .0625");
        assertEquals(0.5, ((Texture.Amount.Constant) c.roughness()).value(), 1e-12);
        Glass g = (Glass) material("Material \"dielectric\" \"float roughness\" .25 \"bool remaproughness\" false");
        assertEquals(0.5, ((Texture.Amount.Constant) g.roughness()).value(), 1e-12);
        Coated two = (Coated) material("Material \"coateddiffuse\" \"float uroughness\" .01"
                + " \"float vroughness\" .09 \"bool remaproughness\" false");
        assertEquals(StrictMath.pow(0.01 * 0.09, 0.25), ((Texture.Amount.Constant) two.roughness()).value(), 1e-12);
    }

    @Test
    void conductorsAreMetalsWithoutMultipleScattering() throws IOException {
        Glossy g = (Glossy)
                material("Material \"conductor\" \"spectrum eta\" \"metal-Au-eta\" \"spectrum k\" \"metal-Au-k\"");
        assertEquals(Optional.of(Glossy.Metal.GOLD.conductor()), g.conductor());
        assertEquals(false, g.multipleScattering());
        Glossy r = (Glossy) material("Material \"conductor\" \"rgb reflectance\" [.5 .5 .5]");
        double k = r.conductor().orElseThrow().k().r();
        assertEquals(0.5, k * k / (4 + k * k), 1e-12);
    }

    @Test
    void glassHasTheIndexOfItsName() throws IOException {
        Glass g = (Glass) material("Material \"dielectric\" \"spectrum eta\" \"glass-BK7\"");
        assertEquals(1.5168, g.indexOfRefraction());
        assertEquals(64.17, g.dispersion().orElseThrow());
        assertEquals(1.7, ((Glass) material("Material \"dielectric\" \"float eta\" 1.7")).indexOfRefraction());
    }

    @Test
    void mediaFillSolids() throws IOException {
        String medium =
                "MakeNamedMedium \"m\" \"string type\" \"homogeneous\" \"rgb sigma_a\" [1 2 3] \"rgb sigma_s\" ";
        Material.Scattering s = (Material.Scattering)
                material(medium + "[4 5 6] \"float scale\" 2 MediumInterface \"m\" \"\" Material \"interface\"");
        assertEquals(new Medium.Coefficients(new Rgb(8, 10, 12), new Rgb(2, 4, 6), 0), s.medium());
        Glass g = (Glass) material(medium + "[0 0 0] MediumInterface \"m\" \"\" Material \"dielectric\"");
        assertEquals(new Rgb(1, 2, 3), g.absorption());
    }

    @Test
    void mixedMaterialsHaveTheAmountOfTheSecond() throws IOException {
        Material m = material("MakeNamedMaterial \"a\" \"string type\" \"diffuse\" \"rgb reflectance\" [1 0 0]"
                + " MakeNamedMaterial \"b\" \"string type\" \"coateddiffuse\""
                + " Material \"mix\" \"string materials\" [\"a\" \"b\"] \"float amount\" .25");
        Composite.Mix mix = (Composite.Mix) m;
        assertInstanceOf(Material.Matte.class, mix.first());
        assertInstanceOf(Coated.class, mix.second());
        assertEquals(Texture.Amount.of(0.25), mix.weight());
    }

    @Test
    void opacityBecomesAMask() throws IOException {
        Composite.Mask m = (Composite.Mask) world("Shape \"sphere\" \"float alpha\" .25")
                .scene()
                .objects()
                .get(0)
                .material();
        assertEquals(Texture.Amount.of(0.25), m.map());
    }

    @Test
    void scalesOfTexturesGoIntoTheMesh() throws IOException {
        Scene scene = world("Texture \"t\" \"spectrum\" \"checkerboard\" \"float uscale\" 4 \"float vdelta\" 3"
                        + " Material \"diffuse\" \"texture reflectance\" \"t\" Shape \"trianglemesh\" "
                        + QUAD + " \"point2 uv\" [0 0 1 0 1 1 0 1]")
                .scene();
        Mesh mesh = (Mesh) scene.objects().get(0).shape();
        assertEquals(4, mesh.triangles().uv(2, 0));
        assertEquals(4, mesh.triangles().uv(2, 1));
        assertEquals(
                new Texture.Checker(List.of(Rgb.WHITE, Rgb.BLACK), 1),
                scene.objects().get(0).material().color());
    }

    @Test
    void aLampShinesToTheSideOfItsNormal() throws IOException {
        assertNear(Vec3.Z, front(""));
        assertNear(Vec3.Z.negated(), front("ReverseOrientation "));
        assertNear(Vec3.Z, front("Scale -1 1 1 "));
        assertNear(Vec3.Z.negated(), front("Scale 1 1 -1 "));
        assertNear(Vec3.Z, front("Scale -1 1 1 Scale 1 -1 1 "));
    }

    private Vec3 front(String before) throws IOException {
        Light.Rectangle r =
                (Light.Rectangle) world("Material \"interface\" AreaLightSource \"diffuse\" \"rgb L\" [1 2 3]\n"
                                + before + "Shape \"trianglemesh\" " + QUAD + " AttributeBegin AttributeEnd"
                                + " Material \"diffuse\" ReverseOrientation Shape \"sphere\"")
                        .scene()
                        .lights()
                        .get(0);
        assertEquals(Emission.radiance(new Rgb(1, 2, 3)), r.emission());
        return ExactPoint.normal(r.lowerLeft(), r.upperLeft(), r.lowerRight()).normalized();
    }

    @Test
    void twoSidedLampsGlowFromBothSides() throws IOException {
        Scene scene = world(
                        "AreaLightSource \"diffuse\" \"rgb L\" [1 2 3] \"bool twosided\" true Shape \"trianglemesh\" "
                                + QUAD)
                .scene();
        assertEquals(List.of(), scene.lights());
        assertEquals(new Rgb(1, 2, 3), scene.objects().get(0).material().radiance());
    }

    @Test
    void powerIsSharedByTheArea() throws IOException {
        Scene scene = world(
                        "AreaLightSource \"diffuse\" \"float power\" 8 \"bool twosided\" true Shape \"trianglemesh\" "
                                + QUAD)
                .scene();
        assertEquals(
                8 / (2 * StrictMath.PI * 4),
                scene.objects().get(0).material().radiance().g(),
                1e-12);
    }

    @Test
    void numbersOfRgbLightsSurviveAndSpectraHaveLuminanceOne() throws IOException {
        assertEquals(new Rgb(2, 4, 6), sky("\"rgb L\" [1 2 3] \"float scale\" 2"));
        for (String spectrum :
                List.of("\"blackbody L\" 3000", "\"spectrum L\" [400 7 700 9]", "\"spectrum L\" \"stdillum-A\"")) {
            Rgb light = sky(spectrum + " \"float scale\" 5");
            assertEquals(5, 0.2126 * light.r() + 0.7152 * light.g() + 0.0722 * light.b(), 1e-9);
        }
    }

    private Rgb sky(String parameters) throws IOException {
        Scene scene = world("LightSource \"infinite\" " + parameters + " Shape \"sphere\"")
                .scene();
        Shading.Physical shading = (Shading.Physical) scene.shading();
        return ((Shading.Background.Constant) shading.background()).radiance();
    }

    @Test
    void spectraByPairsAreReflectances() throws IOException {
        Material m = material("Material \"diffuse\" \"spectrum reflectance\" [300 .25 900 .25]");
        Rgb c = m.color() instanceof Texture.Solid s ? s.color().linear() : Rgb.BLACK;
        assertEquals(0.25, c.r(), 1e-12);
        assertEquals(0.25, c.b(), 1e-12);
    }

    @Test
    void theFilmsSpeedIsTheExposure() throws IOException {
        Scene scene = read("Film \"rgb\" \"float iso\" 400\nCamera \"perspective\" \"float shutterclose\" 2\n"
                        + "WorldBegin Shape \"sphere\"")
                .scene();
        assertEquals(3, scene.display().exposure(), 1e-12);
    }

    @Test
    void aPointLightStandsWhereItComesFrom() throws IOException {
        Light.Point p =
                (Light.Point) world("Translate 1 0 0 LightSource \"point\" \"point3 from\" [0 2 0] \"rgb I\" [1 2 3]"
                                + " Shape \"sphere\"")
                        .scene()
                        .lights()
                        .get(0);
        assertNear(new Vec3(1, 2, 0), point(p.position()));
        assertEquals(Emission.intensity(new Rgb(1, 2, 3)), p.emission());
    }

    @Test
    void aDistantLightShinesFromOnePointToAnother() throws IOException {
        Light.Distant sun = (Light.Distant)
                world("Rotate 90 0 0 1 LightSource \"distant\" \"point3 from\" [1 1 0] \"point3 to\" [3 1 0]"
                                + " \"rgb L\" [1 2 3] \"float scale\" 2 \"float illuminance\" 5 Shape \"sphere\"")
                        .scene()
                        .lights()
                        .get(0);
        assertNear(Vec3.Y, sun.direction().normalized());
        assertNear(
                new Vec3(10, 20, 30),
                new Vec3(sun.emitted().r(), sun.emitted().g(), sun.emitted().b()));
    }

    @Test
    void attributesAreDefaults() throws IOException {
        Sphere s = (Sphere) shape("Attribute \"shape\" \"float radius\" 3 Shape \"sphere\"");
        assertEquals(3, s.radius());
        Sphere t = (Sphere) shape("Attribute \"shape\" \"float radius\" 3 Shape \"sphere\" \"float radius\" 2");
        assertEquals(2, t.radius());
    }

    @Test
    void whatIsLeftOutIsNotedWithItsLine() throws IOException {
        SceneImporter.Result s =
                world("Shape \"sphere\"\nShape \"curve\" \"point3 P\" [0 0 0]\nActiveTransform EndTime\n"
                        + "Translate 1 1 1\nActiveTransform All\nMaterial \"hair\" Shape \"sphere\"\n");
        assertEquals(3, s.notes().size(), s.notes().toString());
        assertTrue(s.notes().get(0).startsWith("line 3: "), s.notes().toString());
        assertTrue(s.notes().get(1).startsWith("line 5: "), s.notes().toString());
        assertTrue(s.notes().get(2).startsWith("line 7: "), s.notes().toString());
    }
}
