package enlightenment.video;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.ImageFiles;
import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.ImageInputStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

/** Films that are written without ffmpeg, and what becomes of programs that call themselves so. */
class VideoFileTest {
    private static final FrameRate RATE = FrameRate.of(24);

    @TempDir
    Path folder;

    private List<Path> frames;
    private Path out;

    @BeforeEach
    void writeFrames() throws IOException {
        frames = Frames.write(folder);
        out = Files.createDirectory(folder.resolve("out")).resolve("film");
    }

    private VideoFile film() {
        return new VideoFile(frames, RATE, () -> false);
    }

    /** A program that answers as the shell lines say. */
    private Ffmpeg program(String lines) throws IOException {
        Path file = Files.writeString(folder.resolve("ffmpeg"), "#!/bin/sh\n" + lines);
        Files.setPosixFilePermissions(file, PosixFilePermissions.fromString("rwx------"));
        return Ffmpeg.at(file);
    }

    private List<Path> outputs() throws IOException {
        try (Stream<Path> all = Files.list(out.getParent())) {
            return all.toList();
        }
    }

    @Test
    void theJdkWritesGifFilesThatPlayForEverAtTheFilmsRate() throws IOException {
        film().write(out, VideoFormat.GIF, Optional.empty());
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        try (ImageInputStream in = ImageIO.createImageInputStream(out.toFile())) {
            reader.setInput(in);
            assertEquals(Frames.COUNT, reader.getNumImages(true));
            int hundredths = 0;
            for (int i = 0; i < Frames.COUNT; i++) {
                IIOMetadataNode root =
                        (IIOMetadataNode) reader.getImageMetadata(i).getAsTree("javax_imageio_gif_image_1.0");
                IIOMetadataNode control = (IIOMetadataNode)
                        root.getElementsByTagName("GraphicControlExtension").item(0);
                hundredths += Integer.parseInt(control.getAttribute("delayTime"));
                assertEquals(
                        i == 0 ? 1 : 0,
                        root.getElementsByTagName("ApplicationExtension").getLength());
            }
            assertEquals(100 * Frames.COUNT / 24, hundredths);
        } finally {
            reader.dispose();
        }
    }

    @Test
    void anAnimatedPngShowsItsFirstFrameToWhomeverKnowsNoBetter() throws IOException {
        film().write(out, VideoFormat.APNG, Optional.empty());
        assertArrayEquals(
                ImageFiles.read(frames.get(0)).toArray(), ImageFiles.read(out).toArray());
    }

    @Test
    void aFrameThatCannotBeReadIsNamed() throws IOException {
        Files.writeString(frames.get(5), "no picture");
        for (VideoFormat format : List.of(VideoFormat.APNG, VideoFormat.GIF)) {
            IOException e = assertThrows(IOException.class, () -> film().write(out, format, Optional.empty()));
            assertTrue(e.getMessage().contains("frame-5.png"), e.getMessage());
            assertEquals(List.of(), outputs());
        }
    }

    @Test
    void aFilmThatIsCancelledIsNotWritten() throws IOException {
        Files.writeString(out, "before");
        VideoFile film = new VideoFile(frames, RATE, () -> true);
        assertThrows(CancellationException.class, () -> film.write(out, VideoFormat.APNG, Optional.empty()));
        assertEquals("before", Files.readString(out));
        assertEquals(List.of(out), outputs());
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void aProgramThatFailsSaysWhyAndLeavesNothing() throws IOException {
        Ffmpeg broken = program("echo 'no such codec' >&2; exit 3\n");
        IOException e = assertThrows(IOException.class, () -> film().write(out, VideoFormat.MP4, Optional.of(broken)));
        assertTrue(e.getMessage().contains("ffmpeg failed (exit code 3): no such codec"), e.getMessage());
        assertEquals(List.of(), outputs());
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void ofAProgramThatTalksForEverTheEndIsToldShortly() throws IOException {
        Ffmpeg talker = program("cat >/dev/null; yes nonsense | head -c 3000000 >&2; exit 1\n");
        IOException e = assertThrows(IOException.class, () -> film().write(out, VideoFormat.MP4, Optional.of(talker)));
        assertTrue(e.getMessage().length() < 2500, e.getMessage().length() + " characters");
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void theProgramGetsTheFramesAsTheyAreAndItsFileBecomesTheFilm() throws IOException {
        Ffmpeg copies = program("for last; do :; done; cat > \"$last\"\n");
        film().write(out, VideoFormat.MKV, Optional.of(copies));
        byte[] all = new byte[0];
        for (Path frame : frames) {
            byte[] png = Files.readAllBytes(frame);
            byte[] longer = java.util.Arrays.copyOf(all, all.length + png.length);
            System.arraycopy(png, 0, longer, all.length, png.length);
            all = longer;
        }
        assertArrayEquals(all, Files.readAllBytes(out));
        assertEquals(List.of(out), outputs());
    }

    /** It reads nothing and never ends: without being killed it would hold us for ever. */
    @Test
    @DisabledOnOs(OS.WINDOWS)
    void aProgramIsKilledWhenWeAreToStop() throws IOException {
        AtomicBoolean stop = new AtomicBoolean();
        Path started = folder.resolve("started");
        // Moved into place: a file that is there has its number, even if the program is killed at once.
        Path begun = folder.resolve("begun");
        Ffmpeg stuck = program("echo $$ > '" + begun + "'; mv '" + begun + "' '" + started + "'; exec sleep 1000\n");
        VideoFile film = new VideoFile(frames, RATE, stop::get);
        Thread asks = new Thread(() -> {
            while (!Files.exists(started)) {
                Thread.onSpinWait();
            }
            stop.set(true);
        });
        asks.start();
        assertThrows(CancellationException.class, () -> film.write(out, VideoFormat.MP4, Optional.of(stuck)));
        assertFalse(Files.exists(out));
        long process = Long.parseLong(Files.readString(started).strip());
        assertFalse(ProcessHandle.of(process).map(ProcessHandle::isAlive).orElse(false));
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void whatIsNotFfmpegIsFoundOutBeforeAnythingIsRendered() throws IOException {
        IOException e =
                assertThrows(IOException.class, () -> program("exit 1\n").check(VideoFormat.MP4, () -> false));
        assertTrue(e.getMessage().contains("does not answer as ffmpeg does (exit code 1)"), e.getMessage());
        Ffmpeg poor = program("echo 'Encoders:'; echo ' V..... ffv1  FFmpeg video codec'\n");
        poor.check(VideoFormat.MKV, () -> false);
        IOException lacks = assertThrows(IOException.class, () -> poor.check(VideoFormat.MP4, () -> false));
        assertTrue(lacks.getMessage().contains("built without the encoder libx264"), lacks.getMessage());
    }

    @Test
    @DisabledOnOs(OS.WINDOWS)
    void theWorkingFolderIsNotSearchedForPrograms() throws IOException {
        Path file = program("exit 0\n").file();
        assertEquals(
                Optional.of(file),
                Ffmpeg.onPath("nowhere" + File.pathSeparator + folder).map(Ffmpeg::file));
        assertEquals(Optional.empty(), Ffmpeg.onPath("" + File.pathSeparator + "."));
        assertEquals(Optional.empty(), Ffmpeg.onPath(null));
        Path here = Path.of("").toAbsolutePath();
        assertEquals(
                Optional.empty(),
                Ffmpeg.onPath(here.relativize(folder.toAbsolutePath()).toString()));
    }
}
