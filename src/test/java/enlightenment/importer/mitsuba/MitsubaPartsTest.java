package enlightenment.importer.mitsuba;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Rgb;
import enlightenment.geometry.Mesh;
import enlightenment.importer.SceneImporter;
import enlightenment.importer.support.ImportDraft;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Parts of scenes that stand elsewhere, are lost, or have holes. */
class MitsubaPartsTest {
    @TempDir
    Path folder;

    private MitsubaScenes scenes;

    @BeforeEach
    void scenes() {
        scenes = new MitsubaScenes(folder);
    }

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
}
