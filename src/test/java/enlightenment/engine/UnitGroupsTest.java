package enlightenment.engine;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.physical.InvarianceScenes;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class UnitGroupsTest {
    private static final Scene SCENE = InvarianceScenes.byRadiance();
    private static final DividedRender RENDER =
            DividedRender.prepare(SCENE, RenderSettings.of(SCENE).withThreads(1).withAntialias(1), () -> false);

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 5, 1000})
    void everyUnitIsInOneGroupAndBatchesAreAlone(int size) {
        UnitGroups groups = UnitGroups.of(RENDER.outline(), size);
        WorkUnits units = WorkUnits.forMachines(
                RENDER.outline().settings(), RENDER.outline().plan());
        assertTrue(units.batches() > 0);
        int next = 0;
        for (int group = 0; group < groups.count(); group++) {
            assertEquals(next, groups.first(group));
            int of = groups.last(group) - groups.first(group);
            assertTrue(of >= 1 && of <= (group < units.batches() ? 1 : size));
            next = groups.last(group);
        }
        assertEquals(RENDER.units(), next);
        assertThrows(IndexOutOfBoundsException.class, () -> groups.first(groups.count()));
    }

    @Test
    void aGroupsResultIsTheResultsOfItsUnits() {
        UnitGroups groups = UnitGroups.of(RENDER.outline(), 3);
        int group = groups.count() - 2;
        byte[] all = groups.maker(RENDER.maker()).make(group);
        List<byte[]> split = groups.split(group, all).orElseThrow();
        assertEquals(groups.last(group) - groups.first(group), split.size());
        for (int i = 0; i < split.size(); i++) {
            assertArrayEquals(RENDER.maker().make(groups.first(group) + i), split.get(i));
        }
        for (int length : new int[] {0, 3, 4, all.length - 1}) {
            assertTrue(groups.split(group, Arrays.copyOf(all, length)).isEmpty());
        }
        assertTrue(groups.split(group, Arrays.copyOf(all, all.length + 1)).isEmpty());
        byte[] huge = all.clone();
        Arrays.fill(huge, 0, 4, (byte) 0x7F);
        assertTrue(groups.split(group, huge).isEmpty());
    }

    @Test
    void aLayoutFindsThePictureOfEachUnit() {
        FrameLayout layout = new FrameLayout(new int[] {3, 1, 4});
        assertEquals(3, layout.frames());
        assertEquals(8, layout.units());
        int[] frames = new int[8];
        Arrays.setAll(frames, layout::frame);
        assertArrayEquals(new int[] {0, 0, 0, 1, 2, 2, 2, 2}, frames);
        assertEquals(4, layout.first(2));
        assertThrows(IndexOutOfBoundsException.class, () -> layout.frame(8));
        assertThrows(IllegalArgumentException.class, () -> new FrameLayout(new int[] {1, 0}));
    }
}
