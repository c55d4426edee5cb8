package enlightenment.importer.mitsuba;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.importer.SceneImporter;
import enlightenment.importer.support.ImportDraft;
import enlightenment.material.Glass;
import enlightenment.material.Material;
import enlightenment.material.Medium;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Parts of scenes that stand elsewhere, are lost, or have holes, and what fills them. Expected values follow from Mitsuba's documentation. */
class MitsubaPartsTest extends MitsubaSceneTest {
    @Test
    void lampsOfAreasThatAreDefinedApartShineWhereTheyAreReferredTo() throws IOException {
        ImportDraft draft = scenes.read(
                "<emitter type=\"area\" id=\"glow\"><rgb name=\"radiance\" value=\"2\"/></emitter>"
                        + "<bsdf type=\"diffuse\" id=\"grey\"/>"
                        + "<shape type=\"sphere\"><ref name=\"bsdf\" id=\"grey\"/><ref name=\"emitter\" id=\"glow\"/></shape>");
        assertEquals(List.of(), draft.notes().list());
        assertEquals(Rgb.gray(2), draft.objects().get(0).material().radiance());
    }

    @Test
    void whatWasLeftOutIsToldWhereNothingIsLeft() throws IOException {
        Path file = scenes.write(
                "empty.xml",
                "<scene version=\"3.0.0\">\n<shape type=\"ply\"><string name=\"filename\" value=\"lost.ply\"/>"
                        + "<boolean name=\"odd\" value=\"true\"/></shape>\n</scene>");
        SceneException e =
                assertThrows(SceneException.class, () -> SceneImporter.read(file, SceneImporter.Options.DEFAULT));
        assertTrue(
                e.getMessage()
                        .endsWith("there is nothing to be seen in the file: line 2: a shape is left out:"
                                + " there is no file \"lost.ply\" that can be read"),
                e.getMessage());
    }

    @Test
    void glassFillsMeshesWithSmallHoles() throws IOException {
        // A bar of 1 x 1 x 5 without one of its small faces: 1 of 21.
        scenes.write(
                "bar.obj",
                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 5\nv 1 0 5\nv 1 1 5\nv 0 1 5\n"
                        + "f 4 3 2 1\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
        String bar = "<shape type=\"obj\"><string name=\"filename\" value=\"bar.obj\"/><bsdf type=\"%s\"/></shape>";
        Mesh glass =
                (Mesh) scenes.read(bar.formatted("dielectric")).objects().get(0).shape();
        assertTrue(glass.enclosesVolume());
        assertEquals(5, glass.triangles().volume(), 1e-12);
        assertFalse(scenes.read(bar.formatted("thindielectric"))
                .objects()
                .get(0)
                .shape()
                .enclosesVolume());
        assertFalse(
                scenes.read(bar.formatted("diffuse")).objects().get(0).shape().enclosesVolume());
    }

    private static final String FOG = "<medium type=\"homogeneous\" id=\"fog\"><float name=\"scale\" value=\"2\"/>"
            + "<rgb name=\"sigma_t\" value=\"1,2,4\"/><rgb name=\"albedo\" value=\"0.5,0.25,1\"/>"
            + "<phase type=\"hg\"><float name=\"g\" value=\"0.3\"/></phase></medium>";

    private Material filled(String type, String bsdf) throws IOException {
        ImportDraft draft = scenes.read(FOG + "<shape type=\"" + type + "\"><bsdf type=\"" + bsdf
                + "\"/><ref name=\"interior\" id=\"fog\"/></shape><shape type=\"cube\"/>");
        return draft.objects().get(0).material();
    }

    @Test
    void mediaFillWhatLightEnters() throws IOException {
        Medium.Coefficients fog = new Medium.Coefficients(new Rgb(1, 1, 8), new Rgb(1, 3, 0), 0.3);
        assertEquals(Material.Scattering.of(fog), filled("sphere", "null"));
        assertEquals(Material.Scattering.of(fog), filled("sphere", "thindielectric"));
        Material.Scattering glass = (Material.Scattering) filled("sphere", "dielectric");
        assertEquals(fog, glass.medium());
        assertEquals(1.5046 / 1.000277, glass.indexOfRefraction(), 1e-12);
        assertEquals(0, glass.roughness());
        assertEquals(Math.sqrt(0.1), ((Material.Scattering) filled("sphere", "roughdielectric")).roughness(), 1e-12);
        assertInstanceOf(Material.Matte.class, filled("sphere", "diffuse"));
    }

    @Test
    void mediaThatOnlyAbsorbColourTheGlass() throws IOException {
        ImportDraft draft = scenes.read(
                "<shape type=\"sphere\"><bsdf type=\"dielectric\"/><medium name=\"interior\""
                        + " type=\"homogeneous\"><float name=\"albedo\" value=\"0\"/><rgb name=\"sigma_t\" value=\"1,2,3\"/></medium></shape>");
        assertEquals(new Rgb(1, 2, 3), ((Glass) draft.objects().get(0).material()).absorption());
        assertEquals(List.of(), draft.notes().list());
    }

    @Test
    void mediaThatVaryOrHaveNoInsideAreLeftOutWithANote() throws IOException {
        ImportDraft open = scenes.read(FOG + "<shape type=\"rectangle\"><bsdf type=\"null\"/><ref name=\"interior\""
                + " id=\"fog\"/></shape><shape type=\"sphere\"><ref name=\"exterior\" id=\"fog\"/></shape>");
        assertEquals(1, open.objects().size());
        assertTrue(open.notes().list().get(0).endsWith("encloses no volume is left out"), open.notes()::toString);
        ImportDraft smoke = scenes.read("<shape type=\"sphere\"><bsdf type=\"null\"/><medium name=\"interior\""
                + " type=\"heterogeneous\"/></shape><shape type=\"cube\"/>");
        assertEquals(1, smoke.objects().size());
        assertTrue(smoke.notes().list().get(0).contains("medium heterogeneous is left out"), smoke.notes()::toString);
    }
}
