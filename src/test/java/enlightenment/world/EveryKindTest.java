package enlightenment.world;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.camera.Camera;
import enlightenment.color.DisplayRgb;
import enlightenment.emitter.Emitter;
import enlightenment.frame.SceneFrame;
import enlightenment.geometry.Shape;
import enlightenment.light.Light;
import enlightenment.material.Material;
import enlightenment.material.Texture;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.primitive.Hit;
import enlightenment.primitive.Primitive;
import enlightenment.primitive.Primitives;
import enlightenment.primitive.Ray;
import enlightenment.primitive.SupportSurface;
import enlightenment.texture.ImageTexture;
import enlightenment.world.camera.CompiledCamera;
import enlightenment.world.light.ClassicLight;
import enlightenment.world.material.SurfaceMaterial;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Every kind of description is compiled: what knows one kind but not another fails here, not in a picture. */
class EveryKindTest {
    private static final int WIDTH = 20;
    private static final int HEIGHT = 10;

    static Stream<Shape> shapes() {
        return Descriptions.SHAPES.stream();
    }

    static Stream<Light> lights() {
        return Descriptions.LIGHTS.stream().filter(Light::isForClassicShading);
    }

    static Stream<Camera> cameras() {
        return Descriptions.CAMERAS.stream();
    }

    @ParameterizedTest
    @MethodSource("shapes")
    void aShapeIsPlacedAsAPrimitiveThatRaysMeetWithinItsBounds(Shape shape) {
        Primitive p = Primitives.place(shape, SceneFrame.WORLD);
        Hit hit = new Hit();
        Ray ray = Ray.of(Vec3.ZERO, Vec3.Z);
        assertTrue(p.intersect(ray, hit), shape.type());
        assertTrue(hit.t >= 2.5 && hit.t <= 4.5, shape.type() + " met at " + hit.t);
        assertTrue(p.bounds().contains(hit.point()), shape.type());
        assertEquals(1, Primitives.placeAll(shape, SceneFrame.WORLD).size(), shape.type());
        assertEquals(hit.t, p.nearest(ray, Double.MAX_VALUE));
        p.textureCoordinates(hit);
        assertTrue(hit.u >= 0 && hit.u <= 1 && hit.v >= 0 && hit.v <= 1, shape.type());
        assertTrue(hit.face >= 0 && hit.face < p.faceCount());
        // Meshes are not compared with what touches them.
        boolean isCompared = !(p.support(hit.face) instanceof SupportSurface.Facets);
        assertEquals(isCompared, p.support(hit.face).passes(hit.point(), 1e-14), shape.type());
        // A primitive is solid if a ray can be inside it; then it contains the point just behind the hit.
        assertEquals(p.isSolid(), p.contains(0, 0, hit.t + 1e-9), shape.type());
    }

    /** The frame is chosen by anchors and reach, so a shape that is larger than they say would leave it. */
    @ParameterizedTest
    @MethodSource("shapes")
    void anchorsAndReachBoundAShape(Shape shape) {
        Vec3 lo = shape.anchors().get(0).toVec3();
        Vec3 hi = lo;
        for (ExactPoint a : shape.anchors()) {
            Vec3 v = a.toVec3();
            lo = new Vec3(Math.min(lo.x(), v.x()), Math.min(lo.y(), v.y()), Math.min(lo.z(), v.z()));
            hi = new Vec3(Math.max(hi.x(), v.x()), Math.max(hi.y(), v.y()), Math.max(hi.z(), v.z()));
        }
        Primitive p = Primitives.place(shape, SceneFrame.WORLD);
        double reach = shape.reach() + 1e-14;
        for (int k = 0; k < 3; k++) {
            assertTrue(p.bounds().min().component(k) >= lo.component(k) - reach, shape.type());
            assertTrue(p.bounds().max().component(k) <= hi.component(k) + reach, shape.type());
        }
    }

    @Test
    void everyKindHasANameOfItsOwn() {
        assertDistinct(Descriptions.SHAPES.stream().map(Shape::type).toList());
        assertDistinct(Descriptions.LIGHTS.stream().map(Light::type).toList());
        assertDistinct(Descriptions.CAMERAS.stream().map(Camera::type).toList());
        assertDistinct(Descriptions.MATERIALS.stream().map(Material::type).toList());
    }

    private static void assertDistinct(List<?> all) {
        Set<?> set = new HashSet<>(all);
        assertEquals(all.size(), set.size(), "two of " + all);
    }

    @ParameterizedTest
    @MethodSource("lights")
    void aLightIsCompiledWithABallAroundItsSurface(Light light) {
        ClassicLight compiled = new ClassicLight(light, SceneFrame.WORLD);
        assertEquals(light.color().display().r(), compiled.r);
        assertEquals(light.color().display().g(), compiled.g);
        assertEquals(light.color().display().b(), compiled.b);
        Vec3 center = new Vec3(compiled.ballX, compiled.ballY, compiled.ballZ);
        for (ExactPoint anchor : light.anchors()) {
            assertTrue(anchor.toVec3().minus(center).length() <= compiled.ballRadius + 1e-15, light.type());
        }
        assertTrue(light.reach() <= compiled.ballRadius, light.type());
        // Either it has a surface that rays meet, or it has no extent.
        assertEquals(compiled.ballRadius > 0, compiled.surface != null, light.type());
    }

    @Test
    void everyLightIsOfAKindOfItsOwn() {
        assertDistinct(lights().map(l -> new ClassicLight(l, SceneFrame.WORLD).emitter.getClass())
                .toList());
        assertEquals(Emitter.class.getPermittedSubclasses().length, lights().count());
    }

    @ParameterizedTest
    @MethodSource("cameras")
    void aCameraIsCompiledToRaysTowardsWhatItLooksAt(Camera camera) {
        SceneFrame frame = new SceneFrame(camera.origin(), 0);
        CompiledCamera compiled = CompiledCamera.of(camera, frame, WIDTH, HEIGHT);
        Ray ray = new Ray();
        compiled.ray(0.5, 0.5, ray);
        Vec3 o = new Vec3(ray.ox, ray.oy, ray.oz);
        Vec3 d = new Vec3(ray.dx, ray.dy, ray.dz);
        Vec3 target = frame.toFrame(ExactPoint.of(0, 0, 4)).minus(o);
        assertEquals(0, target.cross(d).length(), 1e-14 * d.length(), camera.type());
        assertTrue(camera.anchors().size() > 0);
    }

    @Test
    void everyMaterialIsOfAKindOfItsOwnAndKeepsItsColour() {
        assertDistinct(Descriptions.CLASSIC_MATERIALS.stream()
                .map(m -> new SurfaceMaterial(m, null).bsdf.getClass())
                .toList());
        double[] rgb = new double[3];
        for (Material m : Descriptions.CLASSIC_MATERIALS) {
            SurfaceMaterial compiled = new SurfaceMaterial(m, null);
            assertFalse(compiled.isTextured());
            compiled.color(rgb);
            assertArrayEquals(new double[] {1, 0.25, 0.125}, rgb, m.type());
            assertEquals(m.receivesShadows(), compiled.receivesShadows);
        }
    }

    @Test
    void everyTextureIsCompiled(@TempDir Path folder) throws IOException {
        Path file = folder.resolve("green.bmp");
        // A BMP of one pixel: header of 54 bytes, 24 bits per pixel, blue, green, red and a byte of padding.
        byte[] bmp = new byte[58];
        int[] header = {'B', 'M', 58, 0, 0, 0, 0, 0, 0, 0, 54, 0, 0, 0, 40, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 24};
        for (int i = 0; i < header.length; i++) {
            bmp[i] = (byte) header[i];
        }
        bmp[55] = (byte) 255;
        Files.write(file, bmp);
        ImageTexture image = ImageTexture.read(file);
        double[] rgb = new double[3];
        for (Texture texture : Descriptions.TEXTURES) {
            SurfaceMaterial compiled =
                    new SurfaceMaterial(Material.Matte.of(texture), texture instanceof Texture.File ? image : null);
            assertNotNull(compiled.appearance());
            compiled.color(0.75, 0.25, false, rgb);
            DisplayRgb expected = texture instanceof Texture.Solid s
                    ? s.color().display()
                    // Of 2 × 2 squares the one at the upper right has the second colour.
                    : texture instanceof Texture.Checker c ? c.colors().get(1).display() : new DisplayRgb(0, 1, 0);
            assertArrayEquals(new double[] {expected.r(), expected.g(), expected.b()}, rgb, 1e-15, texture.toString());
        }
    }
}
