package enlightenment.importer.mitsuba;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.importer.support.ImportDraft;
import enlightenment.material.Coated;
import enlightenment.material.Composite;
import enlightenment.material.Glass;
import enlightenment.material.Glossy;
import enlightenment.material.Material;
import enlightenment.material.Principled;
import enlightenment.material.Texture;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class MitsubaBsdfTest extends MitsubaSceneTest {
    private static String bsdf(String type, String inside) {
        return "<bsdf type=\"" + type + "\">" + inside + "</bsdf>";
    }

    @Test
    void diffuseIsMatteOfItsLinearReflectance() throws IOException {
        Material m = scenes.material(bsdf("diffuse", "<rgb name=\"reflectance\" value=\"0.1 0.2, 0.3\"/>"));
        assertEquals(Material.Matte.of(Texture.of(new Rgb(0.1, 0.2, 0.3))), m);
    }

    @Test
    void shapesWithoutBsdfAreMatteHalfGrey() throws IOException {
        assertEquals(Material.Matte.of(Texture.of(Rgb.gray(0.5))), scenes.material(""));
    }

    @Test
    void alphaIsTheSquareOfOurRoughness() throws IOException {
        Glossy m = (Glossy) scenes.material(bsdf(
                "roughconductor",
                "<float name=\"alpha\" value=\"0.09\"/><string name=\"distribution\" value=\"ggx\"/>"
                        + "<string name=\"material\" value=\"Au\"/>"));
        assertEquals(0.3, ((Texture.Amount.Constant) m.roughness()).value(), 1e-15);
        assertEquals(Glossy.Metal.GOLD.conductor(), m.conductor().orElseThrow());
    }

    @Test
    void roughSurfacesHaveNoMultipleScatteringAsInMitsuba() throws IOException {
        String ggx = "<string name=\"distribution\" value=\"ggx\"/>";
        assertFalse(((Glossy) scenes.material(bsdf("roughconductor", ggx))).multipleScattering());
        assertFalse(((Glass) scenes.material(bsdf("roughdielectric", ggx))).multipleScattering());
    }

    @Test
    void anisotropyBecomesTheGeometricMeanAndBeckmannGgxWithANote() throws IOException {
        ImportDraft draft = scenes.read("<shape type=\"sphere\">"
                + bsdf(
                        "roughconductor",
                        "<float name=\"alpha_u\" value=\"0.04\"/><float name=\"alpha_v\" value=\"0.25\"/>")
                + "</shape>");
        Glossy m = (Glossy) draft.objects().get(0).material();
        assertEquals(0.1, StrictMath.pow(((Texture.Amount.Constant) m.roughness()).value(), 2), 1e-15);
        String notes = String.join("\n", draft.notes().list());
        assertTrue(notes.contains("beckmann") && notes.contains("anisotropic"), notes);
    }

    @Test
    void smoothConductorWithoutMaterialIsAMirror() throws IOException {
        assertInstanceOf(Material.Mirror.class, scenes.material(bsdf("conductor", "")));
    }

    @Test
    void conductorsTakeEtaAndK() throws IOException {
        Glossy m = (Glossy) scenes.material(
                bsdf("conductor", "<rgb name=\"eta\" value=\"1, 2, 3\"/><rgb name=\"k\" value=\"4, 5, 6\"/>"));
        assertEquals(new Rgb(1, 2, 3), m.conductor().orElseThrow().eta());
        assertEquals(new Rgb(4, 5, 6), m.conductor().orElseThrow().k());
        assertEquals(Texture.Amount.of(0), m.roughness());
    }

    @Test
    void dielectricIsRelativeToAir() throws IOException {
        Glass usual = (Glass) scenes.material(bsdf("dielectric", ""));
        assertEquals(1.5046 / 1.000277, usual.indexOfRefraction(), 1e-15);
        Glass water = (Glass) scenes.material(
                bsdf("dielectric", "<string name=\"int_ior\" value=\"water\"/><float name=\"ext_ior\" value=\"1\"/>"));
        assertEquals(1.333, water.indexOfRefraction(), 1e-15);
    }

    @Test
    void plasticIsCoatedWithItsFlag() throws IOException {
        Coated m = (Coated) scenes.material(bsdf(
                "roughplastic",
                "<string name=\"distribution\" value=\"ggx\"/><float name=\"alpha\""
                        + " value=\"0.16\"/><float name=\"int_ior\" value=\"1.6\"/><float name=\"ext_ior\""
                        + " value=\"1\"/><boolean name=\"nonlinear\" value=\"true\"/><rgb"
                        + " name=\"diffuse_reflectance\" value=\"0.7\"/>"));
        assertEquals(new Coated(Texture.of(Rgb.gray(0.7)), 0.4, 1.6, true, Rgb.BLACK, 0), m);
    }

    @Test
    void smoothPlasticHasASmoothCoat() throws IOException {
        Coated m = (Coated) scenes.material(bsdf("plastic", ""));
        assertEquals(Texture.Amount.of(0), m.roughness());
        assertEquals(1.49 / 1.000277, m.indexOfRefraction(), 1e-15);
    }

    @Test
    void twosidedIsUnwrapped() throws IOException {
        assertInstanceOf(Coated.class, scenes.material(bsdf("twosided", bsdf("plastic", ""))));
    }

    @Test
    void nullIsNothing() throws IOException {
        assertTrue(scenes.read("<shape type=\"sphere\">" + bsdf("null", "") + "</shape>")
                .objects()
                .isEmpty());
    }

    @Test
    void maskAndBlendBecomeMaskAndMix() throws IOException {
        Composite.Mask mask = (Composite.Mask)
                scenes.material(bsdf("mask", "<float name=\"opacity\" value=\"0.25\"/>" + bsdf("diffuse", "")));
        assertEquals(Texture.Amount.of(0.25), mask.map());
        Composite.Mix mix = (Composite.Mix) scenes.material(bsdf(
                "blendbsdf", "<float name=\"weight\" value=\"0.75\"/>" + bsdf("plastic", "") + bsdf("diffuse", "")));
        assertInstanceOf(Coated.class, mix.first());
        assertInstanceOf(Material.Matte.class, mix.second());
        assertEquals(Texture.Amount.of(0.75), mix.weight());
    }

    @Test
    void reliefsTakeTheirPictures() throws IOException {
        scenes.write("h.png", "");
        String texture = "<texture type=\"bitmap\" name=\"%s\"><string name=\"filename\" value=\"h.png\"/>"
                + "<boolean name=\"raw\" value=\"true\"/></texture>";
        Composite.Bump bump = (Composite.Bump) scenes.material(bsdf(
                "bumpmap",
                texture.formatted("arbitrary") + "<float name=\"scale\" value=\"2\"/>" + bsdf("diffuse", "")));
        assertEquals(2, bump.height());
        Composite.NormalMap normals = (Composite.NormalMap)
                scenes.material(bsdf("normalmap", texture.formatted("normalmap") + bsdf("diffuse", "")));
        assertEquals(Texture.Encoding.LINEAR, ((Texture.File) normals.map()).encoding());
    }

    @Test
    void unknownModelsAndParametersAreNoted() throws IOException {
        ImportDraft draft =
                scenes.read("<shape type=\"sphere\">" + bsdf("hair", "") + "</shape>\n<shape type=\"sphere\">"
                        + bsdf("diffuse", "<float name=\"sparkle\" value=\"1\"/>") + "</shape>");
        List<String> notes = draft.notes().list();
        assertEquals(2, notes.size(), notes::toString);
        assertTrue(notes.get(0).startsWith("line 2: ") && notes.get(0).contains("hair"), notes::toString);
        assertTrue(notes.get(1).startsWith("line 3: ") && notes.get(1).contains("sparkle"), notes::toString);
    }

    @Test
    void namesOfMitsuba06MeanTheSame() throws IOException {
        ImportDraft draft = scenes.read(
                "0.6.0",
                "<shape type=\"sphere\"><bsdf type=\"roughplastic\"><string name=\"distribution\" value=\"ggx\"/>"
                        + "<float name=\"intIOR\" value=\"2\"/><float name=\"extIOR\" value=\"1\"/>"
                        + "<spectrum name=\"diffuseReflectance\" value=\"0.3\"/></bsdf></shape>");
        Coated m = (Coated) draft.objects().get(0).material();
        assertEquals(2, m.indexOfRefraction());
        assertEquals(Texture.of(Rgb.gray(0.3)), m.color());
        assertEquals(1, draft.notes().list().size());
        assertTrue(draft.notes().list().get(0).endsWith("is brighter"), draft.notes()::toString);
    }

    @Test
    void rawBitmapsAreLinearAndOthersEncoded() throws IOException {
        scenes.write("a.png", "");
        String bitmap =
                "<texture type=\"bitmap\" name=\"reflectance\"><string name=\"filename\" value=\"a.png\"/>%s</texture>";
        Texture.File usual = (Texture.File)
                scenes.material(bsdf("diffuse", bitmap.formatted(""))).color();
        assertEquals(Texture.Encoding.SRGB, usual.encoding());
        Texture.File raw = (Texture.File)
                scenes.material(bsdf("diffuse", bitmap.formatted("<boolean name=\"raw\" value=\"true\"/>")))
                        .color();
        assertEquals(Texture.Encoding.LINEAR, raw.encoding());
    }

    @Test
    void aSpectrumOfOneEverywhereIsWhiteAsAReflectance() throws IOException {
        Rgb flat = ((Material.Matte) scenes.material(
                                        bsdf("diffuse", "<spectrum name=\"reflectance\" value=\"300:0.5, 900:0.5\"/>")))
                                .color()
                        instanceof Texture.Solid s
                ? s.color().linear()
                : Rgb.BLACK;
        assertEquals(0.5, flat.r(), 1e-12);
        assertEquals(0.5, flat.g(), 1e-12);
        assertEquals(0.5, flat.b(), 1e-12);
    }

    private Texture.File picture(String name, float value) throws IOException {
        ImageFiles.writePng(new Image(1, 1, new float[] {value, value, value}), folder.resolve(name));
        return new Texture.File(folder.resolve(name), Texture.Filter.BILINEAR, Texture.Encoding.LINEAR);
    }

    private static String raw(String name, String file) {
        return "<texture type=\"bitmap\" name=\"" + name + "\"><string name=\"filename\" value=\"" + file
                + "\"/><boolean name=\"raw\" value=\"true\"/></texture>";
    }

    @Test
    void aPictureOfAlphaBecomesOneOfItsRoot() throws IOException {
        picture("a.png", 0.2F);
        String ggx = "<string name=\"distribution\" value=\"ggx\"/>";
        Glossy m = (Glossy) scenes.material(bsdf("roughconductor", ggx + raw("alpha", "a.png")));
        Texture.File made = (Texture.File) m.roughness().textures().get(0);
        assertEquals(Texture.Encoding.LINEAR, made.encoding());
        assertEquals(StrictMath.sqrt(51 / 255.0), ImageFiles.read(made.file()).component(0, 0, 1), 1e-4);
    }

    @Test
    void aCheckerOfAlphaBecomesOneOfItsRoots() throws IOException {
        String checker = "<texture type=\"checkerboard\" name=\"alpha\"><rgb name=\"color0\" value=\"0.25\"/>"
                + "<rgb name=\"color1\" value=\"0.81\"/></texture>";
        Coated m = (Coated) scenes.material(bsdf("roughplastic", checker));
        Texture.Checker c = (Texture.Checker) m.roughness().textures().get(0);
        assertEquals(0.5, c.colors().get(0).linear().g(), 1e-15);
        assertEquals(0.9, c.colors().get(1).linear().g(), 1e-15);
    }

    @Test
    void frostedGlassKeepsItsTextureOfAlpha() throws IOException {
        Texture.File r = picture("r.png", 0.2F);
        String ggx = "<string name=\"distribution\" value=\"ggx\"/>";
        Glass m = (Glass) scenes.material(bsdf("roughdielectric", ggx + raw("alpha", "r.png")));
        Texture.File made = (Texture.File) m.roughness().textures().get(0);
        assertEquals(StrictMath.sqrt(51 / 255.0), ImageFiles.read(made.file()).component(0, 0, 1), 1e-4);
        Glass burley = (Glass) scenes.material(
                bsdf("principled", "<float name=\"spec_trans\" value=\"1\"/>" + raw("roughness", "r.png")));
        assertEquals(Texture.Amount.of(r), burley.roughness());
    }

    @Test
    void principledKeepsItsNumbers() throws IOException {
        Principled m = (Principled) scenes.material(bsdf(
                "principled",
                "<rgb name=\"base_color\" value=\"0.2 0.4 0.6\"/><float name=\"metallic\" value=\"0.25\"/>"
                        + "<float name=\"roughness\" value=\"0.3\"/><float name=\"eta\" value=\"1.7\"/>"
                        + "<float name=\"clearcoat\" value=\"0.5\"/><float name=\"clearcoat_gloss\" value=\"1\"/>"));
        assertEquals(Texture.of(new Rgb(0.2, 0.4, 0.6)), m.color());
        assertEquals(Texture.Amount.of(0.25), m.metallic());
        assertEquals(Texture.Amount.of(0.3), m.roughness());
        assertEquals(1.7, m.indexOfRefraction());
        assertEquals(0.5, m.clearcoat().share());
        double clear = ((Texture.Amount.Constant) m.clearcoat().roughness()).value();
        assertEquals(0.001, clear * clear, 1e-15);
    }

    @Test
    void principledKeepsItsSheen() throws IOException {
        String sheen = "<float name=\"sheen\" value=\"0.75\"/><float name=\"sheen_tint\" value=\"0.25\"/>";
        Principled m = (Principled) scenes.material(bsdf("principled", sheen));
        assertEquals(new Principled.Sheen(0.75, 0.25), m.sheen());
        Principled none =
                (Principled) scenes.material(bsdf("principled", "<float name=\"sheen_tint\" value=\"0.25\"/>"));
        assertEquals(Principled.Sheen.NONE, none.sheen());
    }

    @Test
    void specularIsTheReflectanceAtNormalIncidenceInUnitsOfEightPercent() throws IOException {
        Principled m = (Principled) scenes.material(bsdf("principled", "<float name=\"specular\" value=\"0.7\"/>"));
        double root = (m.indexOfRefraction() - 1) / (m.indexOfRefraction() + 1);
        assertEquals(0.08 * 0.7, root * root, 1e-15);
    }

    @Test
    void principledTakesPicturesAsTheyAre() throws IOException {
        Texture.File r = picture("r.png", 0.5F);
        Principled m = (Principled) scenes.material(
                bsdf("principled", raw("roughness", "r.png") + raw("metallic", "r.png") + raw("base_color", "r.png")));
        assertEquals(r, m.color());
        assertEquals(List.of(r, r), m.textures());
    }

    @Test
    void principledThatTransmitsIsGlassOfTheRootOfItsColour() throws IOException {
        Glass m = (Glass) scenes.material(bsdf(
                "principled",
                "<rgb name=\"base_color\" value=\"0.25 0.36 1\"/><float name=\"spec_trans\" value=\"1\"/>"
                        + "<float name=\"eta\" value=\"1.5\"/><float name=\"roughness\" value=\"0.2\"/>"));
        Rgb c = ((Texture.Solid) m.color()).color().linear();
        assertEquals(0.5, c.r(), 1e-15);
        assertEquals(0.6, c.g(), 1e-15);
        assertEquals(0.2, ((Texture.Amount.Constant) m.roughness()).value(), 1e-15);
        assertEquals(1.5, m.indexOfRefraction());
    }

    /** Half of what is not metal, 0.8, is glass; of the other 0.6, a third is metal. */
    @Test
    void principledThatTransmitsAShareIsPrincipledElsewhere() throws IOException {
        Glass m = (Glass) scenes.material(bsdf(
                "principled",
                "<rgb name=\"base_color\" value=\"0.25 0.36 1\"/><float name=\"spec_trans\" value=\"0.5\"/>"
                        + "<float name=\"metallic\" value=\"0.2\"/><float name=\"roughness\" value=\"0.4\"/>"));
        assertEquals(0.4, m.transparency(), 1e-15);
        Principled rest = (Principled) m.opaque().orElseThrow();
        assertEquals(1.0 / 3, ((Texture.Amount.Constant) rest.metallic()).value(), 1e-15);
        assertEquals(0.25, ((Texture.Solid) rest.color()).color().linear().r(), 1e-15);
    }

    /** Mitsuba 3.9 evaluates to the same numbers whatever these parameters of the dielectric part are. */
    @Test
    void principledMetalIsGlossyWithoutANote() throws IOException {
        String metal = "<rgb name=\"base_color\" value=\"0.9 0.5 0.1\"/><float name=\"metallic\" value=\"1\"/>"
                + "<float name=\"roughness\" value=\"0.3\"/>";
        Material expected = new Glossy(Texture.of(new Rgb(0.9, 0.5, 0.1)), 0.3, Optional.empty(), false, Rgb.BLACK, 0);
        for (String name : List.of("sheen", "sheen_tint", "flatness", "spec_tint", "eta", "specular", "spec_trans")) {
            ImportDraft draft = scenes.read("<shape type=\"sphere\">"
                    + bsdf("principled", metal + "<float name=\"" + name + "\" value=\"0.75\"/>") + "</shape>");
            assertEquals(List.of(), draft.notes().list());
            assertEquals(expected, draft.objects().get(0).material());
        }
        for (String name : List.of("anisotropic", "clearcoat")) {
            ImportDraft draft = scenes.read("<shape type=\"sphere\">"
                    + bsdf("principled", metal + "<float name=\"" + name + "\" value=\"0.75\"/>") + "</shape>");
            assertEquals(1, draft.notes().list().size(), name);
        }
    }

    @Test
    void principledWithAMatteBaseIsNoted() throws IOException {
        ImportDraft draft = scenes.read("<shape type=\"sphere\">"
                + bsdf("principled", "<float name=\"metallic\" value=\"0.5\"/>") + "</shape>");
        assertTrue(draft.notes().list().get(0).contains("another matte base"));
    }

    private ImportDraft principled(String inside) throws IOException {
        return scenes.read("<shape type=\"sphere\">" + bsdf("principled", inside) + "</shape>");
    }

    /** The coat is Mitsuba's: only the base differs. */
    @Test
    void principledWithABlackBaseIsItsCoatWithoutANote() throws IOException {
        String black = "<rgb name=\"base_color\" value=\"0\"/><float name=\"roughness\" value=\"0.3\"/>";
        ImportDraft draft = principled(black + "<float name=\"eta\" value=\"1.5\"/>");
        assertEquals(List.of(), draft.notes().list());
        Principled m = (Principled) draft.objects().get(0).material();
        assertEquals(1.5, m.indexOfRefraction());
        assertEquals(Texture.of(Rgb.BLACK), m.color());
        String metal = principled(black + "<float name=\"metallic\" value=\"0.5\"/>")
                .notes()
                .list()
                .toString();
        assertTrue(metal.contains("has light between facets"), metal);
    }

    @Test
    void principledWithoutMetalAndCoatIsMatte() throws IOException {
        for (String none : List.of("specular\" value=\"0", "eta\" value=\"1")) {
            ImportDraft draft =
                    principled("<rgb name=\"base_color\" value=\"0.2 0.4 0.6\"/><float name=\"" + none + "\"/>");
            assertEquals(
                    Material.Matte.of(Texture.of(new Rgb(0.2, 0.4, 0.6))),
                    draft.objects().get(0).material());
            assertEquals(1, draft.notes().list().size());
            assertTrue(
                    draft.notes().list().get(0).endsWith("has another matte base"),
                    draft.notes().list()::toString);
        }
    }
}
