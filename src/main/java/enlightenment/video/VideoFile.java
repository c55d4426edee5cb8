package enlightenment.video;

import enlightenment.codec.ApngWriter;
import enlightenment.codec.GifWriter;
import enlightenment.codec.PngChunks;
import enlightenment.codec.RasterFiles;
import enlightenment.file.FileFailure;
import enlightenment.file.FilePlace;
import enlightenment.file.TemporaryFile;
import enlightenment.file.WholeFile;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/**
 * A film of frames that are PNG files of one size. It appears as a whole or not at all.
 *
 * @param frames in order, at least one
 * @param rate how fast they are shown
 * @param cancelled asked now and then; once true, nothing is written
 */
public record VideoFile(List<Path> frames, FrameRate rate, BooleanSupplier cancelled) {
    /** Something that takes whole PNG files one after another. */
    interface Sink {
        void add(byte[] png) throws IOException;
    }

    /**
     * Writes or replaces the film.
     *
     * @param ffmpeg writes the formats that use it; without one, GIF is written by the JDK
     * @throws IOException with a message that names the file that is at fault, and why
     * @throws CancellationException if cancelled; what was there before stays
     */
    public void write(Path out, VideoFormat format, Optional<Ffmpeg> ffmpeg) throws IOException {
        if (format == VideoFormat.APNG) {
            WholeFile.write(out, stream -> {
                ApngWriter film = new ApngWriter(stream, frames.size(), rate.seconds(), rate.frames());
                forEach(film::add);
            });
        } else if (ffmpeg.isPresent()) {
            Path place = FilePlace.of(out);
            try (TemporaryFile temporary = TemporaryFile.in(place.getParent())) {
                Path made = ffmpeg.get().write(this, format, temporary.folder());
                WholeFile.write(out, stream -> {
                    try (InputStream in = Files.newInputStream(made)) {
                        in.transferTo(stream);
                    }
                });
            }
        } else if (format == VideoFormat.GIF) {
            WholeFile.write(out, stream -> {
                try (GifWriter film = new GifWriter(stream)) {
                    int[] frame = {0};
                    forEach(png -> film.add(RasterFiles.decode(png), rate.hundredths(frame[0]++)));
                    film.finish();
                }
            });
        } else {
            throw new IOException("cannot write " + out + ": it needs ffmpeg");
        }
    }

    /** Passes all frames on. */
    void forEach(Sink sink) throws IOException {
        for (Path frame : frames) {
            if (cancelled.getAsBoolean()) {
                throw new CancellationException("the film was not finished");
            }
            byte[] png = RasterFiles.read(frame, bytes -> bytes);
            try {
                sink.add(png);
            } catch (IOException e) {
                throw new IOException("frame " + frame + ": " + FileFailure.reason(e), e);
            }
        }
    }

    /**
     * The comment with this keyword in a PNG file that is whole and undamaged as far as its checksums tell; empty if there is none, or
     * the file cannot be read.
     */
    public static Optional<String> comment(Path png, String keyword) {
        try {
            return RasterFiles.read(png, bytes -> PngChunks.comment(bytes, keyword));
        } catch (IOException e) {
            return Optional.empty();
        }
    }
}
