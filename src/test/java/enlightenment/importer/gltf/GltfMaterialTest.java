package enlightenment.importer.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.colorimetry.TransferCurve;
import enlightenment.geometry.Mesh;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.SceneImporter;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What materials and textures of glTF files become. */
class GltfMaterialTest {
    @TempDir
    Path folder;

    /** A PNG file of one row of pixels, 0xAARRGGBB. */
    private static byte[] png(int... pixels) throws IOException {
        BufferedImage image = new BufferedImage(pixels.length, 1, BufferedImage.TYPE_INT_ARGB);
        image.setRGB(0, 0, pixels.length, 1, pixels, 0, pixels.length);
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        return out.toByteArray();
    }

    private SceneImporter.Result read(String material) throws IOException {
        return GltfFile.ofMaterial(material).read(folder);
    }

    private static Material material(SceneImporter.Result imported) {
        return imported.scene().objects().get(0).material();
    }

    private static Path file(Texture texture) {
        return ((Texture.File) texture).file();
    }

    @Test
    void metallicRoughnessIsPrincipled() throws IOException {
        SceneImporter.Result imported = read("{'name':'gold','pbrMetallicRoughness':{'baseColorFactor':[0.9,0.6,0.2,1],"
                + "'metallicFactor':0.75,'roughnessFactor':0.25}}");
        Material expected = Principled.of(Texture.of(new Rgb(0.9, 0.6, 0.2)), 0.75, 0.25);
        assertEquals(expected, material(imported));
        assertEquals(expected, imported.scene().materials().get("gold"));
        assertEquals(List.of(), imported.notes());
    }

    @Test
    void defaultsAreThoseOfTheFormat() throws IOException {
        assertEquals(Principled.of(Texture.of(Rgb.WHITE), 1, 1), material(read("{}")));
        GltfFile none = new GltfFile();
        none.square("");
        none.add("nodes", "{'mesh':0}");
        assertEquals(Principled.of(Texture.of(Rgb.WHITE), 1, 1), material(none.read(folder)));
    }

    @Test
    void extensionsOfDielectricsAreComponents() throws IOException {
        SceneImporter.Result imported = read(
                "{'pbrMetallicRoughness':{'metallicFactor':0},'emissiveFactor':[0.5,0.25,0],"
                        + "'extensions':{'KHR_materials_ior':{'ior':1.25},'KHR_materials_specular':{'specularFactor':0.5},"
                        + "'KHR_materials_clearcoat':{'clearcoatFactor':0.75,'clearcoatRoughnessFactor':0.125},"
                        + "'KHR_materials_emissive_strength':{'emissiveStrength':8},'KHR_materials_sheen':{'sheenColorFactor':[0.25,0.5,0]}}}");
        assertEquals(
                new Principled(
                        Texture.of(Rgb.WHITE),
                        Texture.Amount.of(0),
                        Texture.Amount.of(1),
                        1.25,
                        0.5,
                        new Principled.Clearcoat(0.75, Texture.Amount.of(0.125)),
                        new Principled.Sheen(0.5, 0),
                        new Rgb(4, 2, 0),
                        0),
                material(imported));
        assertEquals(
                List.of("materials/0: KHR_materials_sheen becomes white sheen of another lobe, by the largest component"
                        + " of its factor"),
                imported.notes());
    }

    /** The traps "sRGB or linear textures" and "roughness is linear, channel G, metallic B". */
    @Test
    void colourIsSrgbAndRoughnessIsLinearGreenAndMetallicIsBlue() throws IOException {
        byte[] picture = png(0xff804020, 0xff102030);
        GltfFile file = GltfFile.ofMaterial("{'pbrMetallicRoughness':{'baseColorTexture':{'index':0},"
                + "'metallicRoughnessTexture':{'index':1},'roughnessFactor':0.5}}");
        file.texture(picture);
        file.texture(png(0xff0000ff));
        Principled p = (Principled) material(file.read(folder));
        assertEquals(Texture.Encoding.SRGB, ((Texture.File) p.color()).encoding());
        assertTrue(Arrays.equals(picture, Files.readAllBytes(file(p.color()))), "the picture keeps its bytes");
        Texture.Amount.Textured roughness = (Texture.Amount.Textured) p.roughness();
        Texture.Amount.Textured metallic = (Texture.Amount.Textured) p.metallic();
        assertEquals(Texture.Amount.Channel.GREEN, roughness.channel());
        assertEquals(0.5, roughness.factor());
        assertEquals(Texture.Amount.Channel.BLUE, metallic.channel());
        assertEquals(1, metallic.factor());
        assertEquals(Texture.Encoding.LINEAR, ((Texture.File) roughness.texture()).encoding());
        assertEquals(roughness.texture(), metallic.texture());
    }

    @Test
    void factorsOfColourAreMultipliedIntoACopy() throws IOException {
        GltfFile file = GltfFile.ofMaterial(
                "{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}," + "'baseColorFactor':[0.5,1,0.25,1]}}");
        file.texture(png(0xff804020));
        Principled p = (Principled) material(file.read(folder));
        Image image = ImageFiles.read(file(p.color()));
        double[] sources = {0x80 / 255.0, 0x40 / 255.0, 0x20 / 255.0};
        double[] factors = {0.5, 1, 0.25};
        for (int c = 0; c < 3; c++) {
            assertEquals(
                    TransferCurve.decode(sources[c]) * factors[c],
                    TransferCurve.decode(image.component(0, 0, c)),
                    2e-5);
        }
    }

    @Test
    void opacityIsAMaskOrACutOut() throws IOException {
        String color = "'pbrMetallicRoughness':{'baseColorFactor':[1,1,1,0.25]}";
        Material plain = Principled.of(Texture.of(Rgb.WHITE), 1, 1);
        assertEquals(plain, material(read("{" + color + "}")));
        assertEquals(
                new Composite.Mask(plain, Texture.Amount.of(0.25)),
                material(read("{'alphaMode':'BLEND'," + color + "}")));
        assertEquals(
                new Composite.Mask(plain, Texture.Amount.of(0)), material(read("{'alphaMode':'MASK'," + color + "}")));
        assertEquals(plain, material(read("{'alphaMode':'MASK','alphaCutoff':0.25," + color + "}")));
    }

    @Test
    void opacityComesFromTheAlphaOfTheColourTexture() throws IOException {
        for (boolean isCut : List.of(true, false)) {
            GltfFile file = GltfFile.ofMaterial("{'alphaMode':'" + (isCut ? "MASK" : "BLEND")
                    + "','pbrMetallicRoughness':{'baseColorTexture':{'index':0},'baseColorFactor':[1,1,1,0.75]}}");
            file.texture(png(0xff804020, 0x00804020, 0xb0804020, 0xa0804020));
            Composite.Mask mask = (Composite.Mask) material(file.read(folder));
            Texture.Amount.Textured map = (Texture.Amount.Textured) mask.map();
            Image image = ImageFiles.read(file(map.texture()));
            // 0.75 · 0xb0 / 255 is 0.518, 0.75 · 0xa0 / 255 is 0.471.
            double[] expected = isCut ? new double[] {1, 0, 1, 0} : new double[] {1, 0, 0xb0 / 255.0, 0xa0 / 255.0};
            for (int x = 0; x < 4; x++) {
                assertEquals(expected[x], image.component(x, 0, 0), 1e-4, "pixel " + x);
            }
            assertEquals(isCut ? 1 : 0.75, map.factor());
        }
    }

    @Test
    void normalMapsStayAndTheirScaleIsBakedIn() throws IOException {
        for (double scale : new double[] {1, 0.5}) {
            GltfFile file = GltfFile.ofMaterial("{'normalTexture':{'index':0,'scale':" + scale + "}}");
            file.texture(png(0xffff80ff));
            Composite.NormalMap map = (Composite.NormalMap) material(file.read(folder));
            Image image = ImageFiles.read(file(map.map()));
            // The red component stands for 1 along u, the blue one for 1 outwards: the tangent of the tilt is their
            // ratio.
            double tilt = (2 * image.component(0, 0, 0) - 1) / (2 * image.component(0, 0, 2) - 1);
            assertEquals(scale, tilt, 1e-3);
        }
    }

    @Test
    void transmissionIsGlassWhoseVolumeAbsorbs() throws IOException {
        String extensions = "'extensions':{'KHR_materials_transmission':{'transmissionFactor':1},"
                + "'KHR_materials_ior':{'ior':1.45},'KHR_materials_volume':{'thicknessFactor':1,"
                + "'attenuationDistance':2,'attenuationColor':[0.25,1,1]},'KHR_materials_dispersion':{'dispersion':0.5}}";
        GltfFile file = new GltfFile();
        file.add("materials", "{'pbrMetallicRoughness':{'metallicFactor':0,'roughnessFactor':0}," + extensions + "}");
        int p = file.floats("VEC3", 3, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
        int i = file.indices(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3);
        file.add("meshes", "{'primitives':[{'attributes':{'POSITION':" + p + "},'indices':" + i + ",'material':0}]}");
        file.add("nodes", "{'mesh':0}");
        SceneImporter.Result imported = file.read(folder);
        Glass glass = (Glass) material(imported);
        assertEquals(1.45, glass.indexOfRefraction());
        assertEquals(1, glass.transparency());
        assertEquals(40, glass.dispersion().orElseThrow(), "V = 20 / 0.5");
        // What is left after two units is a quarter of red.
        assertEquals(0.25, StrictMath.exp(-2 * glass.absorption().r()), 1e-15);
        assertEquals(0, glass.absorption().g());
        assertEquals(List.of(), imported.notes());
    }

    @Test
    void whatIsFilledHasNoSmallHoles() throws IOException {
        for (double thickness : new double[] {0, 1}) {
            GltfFile file = new GltfFile();
            file.add(
                    "materials",
                    "{'pbrMetallicRoughness':{'metallicFactor':0,'roughnessFactor':0},'extensions':{"
                            + "'KHR_materials_transmission':{'transmissionFactor':1},"
                            + "'KHR_materials_volume':{'thicknessFactor':" + thickness + "}}}");
            // A spike of height 30 without its base, which has a 60th of the area.
            int p = file.floats("VEC3", 3, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 30);
            int i = file.indices(0, 1, 3, 0, 3, 2, 1, 2, 3);
            file.add(
                    "meshes",
                    "{'primitives':[{'attributes':{'POSITION':" + p + "},'indices':" + i + ",'material':0}]}");
            file.add("nodes", "{'mesh':0}");
            Mesh spike = (Mesh) file.read(folder).scene().objects().get(0).shape();
            assertEquals(thickness > 0, spike.enclosesVolume());
            assertEquals(thickness > 0 ? 4 : 3, spike.triangles().triangles());
        }
    }

    /** Four triangles around a volume, of a material. */
    private static GltfFile tetrahedron(String material) {
        GltfFile file = new GltfFile();
        file.add("materials", material);
        int p = file.floats("VEC3", 3, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1);
        int t = file.floats("VEC2", 2, 0, 0, 1, 0, 0, 1, 1, 1);
        int i = file.indices(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3);
        file.add(
                "meshes",
                "{'primitives':[{'attributes':{'POSITION':" + p + ",'TEXCOORD_0':" + t + "},'indices':" + i
                        + ",'material':0}]}");
        file.add("nodes", "{'mesh':0}");
        return file;
    }

    @Test
    void roughnessOfWhatTransmitsLightIsItsTexture() throws IOException {
        String rough = "{'pbrMetallicRoughness':{'metallicFactor':%d,'roughnessFactor':0.5,"
                + "'metallicRoughnessTexture':{'index':0}},"
                + "'extensions':{'KHR_materials_transmission':{'transmissionFactor':1}}}";
        for (int metallic = 0; metallic <= 1; metallic++) {
            GltfFile file = tetrahedron(rough.formatted(metallic));
            file.texture(png(0xff00ff00, 0xff008000));
            SceneImporter.Result imported = file.read(folder);
            Texture.Amount.Textured roughness = (Texture.Amount.Textured) ((Glass) material(imported)).roughness();
            assertEquals(Texture.Amount.Channel.GREEN, roughness.channel());
            assertEquals(0.5, roughness.factor());
            List<String> metal =
                    List.of("materials/0: the metal of metallicRoughnessTexture is left out of what transmits light");
            assertTrue(imported.notes().containsAll(metallic == 0 ? List.of() : metal), imported.notes()::toString);
            assertEquals(
                    metallic, imported.notes().stream().filter(metal::contains).count());
        }
    }

    @Test
    void roughnessOfTheClearCoatIsTheGreenOfItsTexture() throws IOException {
        GltfFile file = GltfFile.ofMaterial("{'extensions':{'KHR_materials_clearcoat':{'clearcoatFactor':1,"
                + "'clearcoatRoughnessFactor':0.25,'clearcoatRoughnessTexture':{'index':0}}}}");
        file.texture(png(0xff00ff00, 0xff008000));
        SceneImporter.Result imported = file.read(folder);
        Texture.Amount.Textured roughness = (Texture.Amount.Textured)
                ((Principled) material(imported)).clearcoat().roughness();
        assertEquals(Texture.Amount.Channel.GREEN, roughness.channel());
        assertEquals(0.25, roughness.factor());
        assertEquals(Texture.Encoding.LINEAR, ((Texture.File) roughness.texture()).encoding());
        assertEquals(List.of(), imported.notes());
    }

    @Test
    void openMeshesThatTransmitLightAreSmooth() throws IOException {
        SceneImporter.Result imported = read("{'pbrMetallicRoughness':{'metallicFactor':0,'roughnessFactor':0.5},"
                + "'extensions':{'KHR_materials_transmission':{'transmissionFactor':0.5}}}");
        Glass glass = (Glass) material(imported);
        assertTrue(glass.roughness().isZero());
        assertEquals(0.5, glass.transparency());
        assertEquals(List.of("materials/0: what transmits light is smooth: its mesh is not closed"), imported.notes());
    }

    /** A fifth is metal; of the rest a quarter transmits light, so the other 0.8 are metal by one quarter. */
    @Test
    void whatTransmitsAShareIsPrincipledElsewhere() throws IOException {
        Glass glass = (Glass) material(read("{'pbrMetallicRoughness':{'metallicFactor':0.2,'roughnessFactor':0.5},"
                + "'extensions':{'KHR_materials_transmission':{'transmissionFactor':0.25}}}"));
        assertEquals(0.2, glass.transparency(), 1e-15);
        Principled rest = (Principled) glass.opaque().orElseThrow();
        assertEquals(0.25, ((Texture.Amount.Constant) rest.metallic()).value(), 1e-15);
        assertEquals(Texture.Amount.of(0.5), rest.roughness());
    }

    @Test
    void metalTransmitsNothing() throws IOException {
        assertEquals(
                Principled.of(Texture.of(Rgb.WHITE), 1, 0.5),
                material(read("{'pbrMetallicRoughness':{'roughnessFactor':0.5},"
                        + "'extensions':{'KHR_materials_transmission':{'transmissionFactor':1}}}")));
    }

    @Test
    void unlitIsMatteWithANote() throws IOException {
        SceneImporter.Result imported = read("{'extensions':{'KHR_materials_unlit':{}}}");
        assertEquals(Material.Matte.of(Texture.of(Rgb.WHITE)), material(imported));
        assertEquals(1, imported.notes().size());
    }

    @Test
    void textureTransformsAreBakedIntoTheMesh() throws IOException {
        GltfFile file = GltfFile.ofMaterial("{'pbrMetallicRoughness':{'baseColorTexture':{'index':0,'extensions':"
                + "{'KHR_texture_transform':{'offset':[0.5,0.25],'scale':[2,3],'rotation':" + Math.PI / 2 + "}}}}}");
        file.texture(png(0xff804020));
        Mesh mesh = (Mesh) file.read(folder).scene().objects().get(0).shape();
        // The vertex at (1, 0) has u = 1 and, downwards, v = 1: scaled (2, 3), turned counterclockwise as seen with v
        // downwards (3, -2), moved (3.5, -1.75), and v upwards 2.75.
        assertEquals(3.5, mesh.triangles().uv(1, 0), 1e-6);
        assertEquals(2.75, mesh.triangles().uv(1, 1), 1e-6);
    }

    @Test
    void texturesWithOtherCoordinatesAreNoted() throws IOException {
        GltfFile file = GltfFile.ofMaterial("{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}},"
                + "'normalTexture':{'index':0,'extensions':{'KHR_texture_transform':{'scale':[4,4]}}}}");
        file.texture(png(0xff8080ff));
        assertTrue(file.read(folder).notes().toString().contains("its textures have different coordinates"));
    }

    @Test
    void evenEmissiveTexturesAreRadianceAndOthersItsMap() throws IOException {
        for (boolean isEven : List.of(true, false)) {
            GltfFile file = GltfFile.ofMaterial("{'emissiveFactor':[1,1,1],'emissiveTexture':{'index':0}}");
            file.texture(isEven ? png(0xff00ff00, 0xff00ff00) : png(0xff00ff00, 0xff000000));
            SceneImporter.Result imported = file.read(folder);
            Material glowing = material(imported);
            assertEquals(isEven ? new Rgb(0, 1, 0) : Rgb.WHITE, glowing.radiance());
            assertEquals(isEven, glowing.radianceMap().isEmpty());
            assertEquals(List.of(), imported.notes());
            if (!isEven) {
                Texture.File map = (Texture.File) glowing.radianceMap().get();
                assertEquals(Texture.Encoding.SRGB, map.encoding());
            }
        }
    }

    @Test
    void imagesThatCannotBeReadAreLeftOutWithANote() throws IOException {
        GltfFile file = GltfFile.ofMaterial("{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}");
        file.texture("RIFF....WEBPVP8 ".getBytes(java.nio.charset.StandardCharsets.US_ASCII));
        SceneImporter.Result imported = file.read(folder);
        assertEquals(List.of("a texture is left out: images/0: is neither PNG nor JPEG, but WebP"), imported.notes());
        assertEquals(Principled.of(Texture.of(Rgb.WHITE), 1, 1), material(imported));
    }

    @Test
    void alphaOfPngFilesIsReadInAllTheirForms() throws IOException {
        Path opaque = folder.resolve("opaque.png");
        ImageFiles.writePng(new Image(1, 1, new float[] {1, 0, 1}), opaque, ImageFiles.PngOptions.DEFAULT);
        assertTrue(ImageFiles.readAlpha(opaque).isEmpty());
        BufferedImage palette = new BufferedImage(
                4,
                1,
                BufferedImage.TYPE_BYTE_INDEXED,
                new java.awt.image.IndexColorModel(
                        2, 4, new byte[4], new byte[4], new byte[] {0, 80, 90, 100}, new byte[] {0, 85, 127, -1}));
        for (int x = 0; x < 4; x++) {
            palette.getRaster().setSample(x, 0, 0, x);
        }
        Path file = folder.resolve("palette.png");
        ImageIO.write(palette, "png", file.toFile());
        Image alpha = ImageFiles.readAlpha(file).orElseThrow();
        double[] expected = {0, 85 / 255.0, 127 / 255.0, 1};
        for (int x = 0; x < 4; x++) {
            assertEquals(expected[x], alpha.component(x, 0, 1), 1e-7);
        }
    }
}
