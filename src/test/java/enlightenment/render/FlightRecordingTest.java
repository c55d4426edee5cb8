package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.toy.ToyScene;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import jdk.jfr.Recording;
import jdk.jfr.consumer.RecordedEvent;
import jdk.jfr.consumer.RecordingFile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a flight recording tells of a render, although no class of the recorder is used before somebody records. */
class FlightRecordingTest {
    @TempDir
    Path folder;

    @Test
    void aRecordingHasThePhasesAndAllPixelsOfARender() throws IOException {
        Scene scene = ToyScene.scene();
        Path file = folder.resolve("render.jfr");
        try (Recording recording = new Recording()) {
            recording.start();
            Renderer.render(scene, RenderSettings.of(scene).withAntialias(1));
            recording.stop();
            recording.dump(file);
        }
        List<RecordedEvent> events = RecordingFile.readAllEvents(file);
        List<String> phases = events.stream()
                .filter(e -> e.getEventType().getName().equals("enlightenment.RenderPhase"))
                .map(e -> e.getString("phase"))
                .toList();
        assertTrue(phases.containsAll(List.of("compile", "plan", "render", "finish")), phases.toString());
        int pixels = events.stream()
                .filter(e -> e.getEventType().getName().equals("enlightenment.Unit"))
                .mapToInt(e -> e.getInt("pixels"))
                .sum();
        assertEquals(scene.width() * scene.height(), pixels);
    }
}
