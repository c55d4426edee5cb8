package enlightenment.codec;

import java.io.IOException;
import java.util.Arrays;
import java.util.Optional;

/** The kinds of picture files that can be read. What they are called, and which are written, says {@code ImageFormat}. */
public enum RasterDecoder {
    PNG {
        @Override
        public boolean matches(byte[] start) {
            return begins(start, PngWriter.SIGNATURE);
        }

        @Override
        public Raster read(byte[] file) throws IOException {
            return PngReader.read(file);
        }
    },
    JPEG {
        @Override
        public boolean matches(byte[] start) {
            return begins(start, (byte) 0xff, (byte) 0xd8, (byte) 0xff);
        }

        @Override
        public Raster read(byte[] file) throws IOException {
            return ImageIoReader.read(file, ImageIoReader.JPEG);
        }
    },
    BMP {
        @Override
        public boolean matches(byte[] start) {
            return begins(start, (byte) 'B', (byte) 'M');
        }

        @Override
        public Raster read(byte[] file) throws IOException {
            return ImageIoReader.read(file, "bmp");
        }
    },
    PFM {
        @Override
        public boolean matches(byte[] start) {
            return PfmFormat.matches(start);
        }

        @Override
        public Raster read(byte[] file) throws IOException {
            return PfmFormat.read(file);
        }
    },
    HDR {
        @Override
        public boolean matches(byte[] start) {
            return HdrReader.matches(start);
        }

        @Override
        public Raster read(byte[] file) throws IOException {
            return HdrReader.read(file);
        }
    },
    EXR {
        @Override
        public boolean matches(byte[] start) {
            return ExrReader.matches(start);
        }

        @Override
        public Raster read(byte[] file) throws IOException {
            return ExrReader.read(file);
        }
    };

    /** The longest start that {@link #matches} looks at, in bytes. */
    public static final int SIGNATURE_LENGTH = 8;

    /** Whether a file that starts like this is of this kind: decided by at most {@link #SIGNATURE_LENGTH} bytes. */
    public abstract boolean matches(byte[] start);

    /**
     * Decodes a whole file.
     *
     * @param file begins as {@link #matches} asks
     * @throws IOException with the reason, if it is damaged, of an unknown variant or too large
     */
    public abstract Raster read(byte[] file) throws IOException;

    /** The kind of a file that starts like this; empty if it is unknown. */
    public static Optional<RasterDecoder> of(byte[] start) {
        for (RasterDecoder decoder : values()) {
            if (decoder.matches(start)) {
                return Optional.of(decoder);
            }
        }
        return Optional.empty();
    }

    private static boolean begins(byte[] file, byte... start) {
        return file.length >= start.length && Arrays.equals(file, 0, start.length, start, 0, start.length);
    }
}
