package enlightenment.importer.gltf;

import enlightenment.file.InputFile;
import enlightenment.importer.support.InputFolder;
import enlightenment.text.Plain;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.Base64;
import java.util.HashMap;
import java.util.Map;

/** The bytes of a glTF file's buffers and views: inside a GLB, in data URIs, and in files beside it. Each is read when it is first used. */
final class GltfBuffers {
    private static final String DATA = "data:";
    private static final String BASE64 = ";base64,";

    private final GltfContainer file;
    private final InputFolder folder;
    private final Map<Integer, ByteBuffer> buffers = new HashMap<>();
    private long size;

    GltfBuffers(GltfContainer file, InputFolder folder) {
        this.file = file;
        this.folder = folder;
        size = file.size();
    }

    /** Bytes of the file and of all buffers that have been read. */
    long size() {
        return size;
    }

    /** The bytes of a buffer view, little-endian, from position 0. */
    ByteBuffer view(int index) throws IOException {
        GltfElement view = file.document().item("bufferViews", index);
        if (view.extension("EXT_meshopt_compression").isPresent()) {
            throw view.failure("is compressed by EXT_meshopt_compression, which cannot be read: export without it");
        }
        int count = file.document().size("buffers");
        ByteBuffer all = buffer(view.index("buffer", count).orElseThrow(() -> view.failure("lacks \"buffer\"")));
        long offset = view.whole("byteOffset", 0);
        long length = view.whole("byteLength");
        if (offset > all.limit() || length > all.limit() - offset) {
            throw view.failure(
                    "reaches beyond its buffer: bytes " + offset + " to " + (offset + length) + " of " + all.limit());
        }
        return all.slice((int) offset, (int) length).order(ByteOrder.LITTLE_ENDIAN);
    }

    private ByteBuffer buffer(int index) throws IOException {
        ByteBuffer known = buffers.get(index);
        if (known != null) {
            return known;
        }
        GltfElement buffer = file.document().item("buffers", index);
        long length = buffer.whole("byteLength");
        ByteBuffer bytes;
        if (buffer.has("uri")) {
            bytes = ByteBuffer.wrap(resource(buffer));
            size += bytes.limit();
        } else if (index == 0 && file.isBinary()) {
            bytes = file.binary();
        } else {
            throw buffer.failure("has neither a \"uri\" nor a place in a GLB file");
        }
        if (length > bytes.limit()) {
            throw buffer.failure("says " + length + " bytes, and there are " + bytes.limit());
        }
        buffers.put(index, bytes.slice(0, (int) length));
        return buffers.get(index);
    }

    /** The bytes that the {@code uri} of a buffer or an image stands for: a data URI, or a file. */
    byte[] resource(GltfElement of) throws IOException {
        String uri = of.text("uri", "");
        if (isData(uri)) {
            return data(uri, of);
        }
        try {
            return InputFile.bytes(folder.file(decoded(uri)));
        } catch (IOException e) {
            throw of.failure(e.getMessage());
        }
    }

    static boolean isData(String uri) {
        return uri.regionMatches(true, 0, DATA, 0, DATA.length());
    }

    private static byte[] data(String uri, GltfElement of) throws IOException {
        int comma = uri.indexOf(',');
        if (comma < 0
                || !uri.substring(0, comma + 1)
                        .toLowerCase(java.util.Locale.ROOT)
                        .endsWith(BASE64)) {
            throw of.failure("has a data URI that is not in base64: it begins with " + Plain.quoted(uri));
        }
        try {
            return Base64.getDecoder().decode(uri.substring(comma + 1));
        } catch (IllegalArgumentException e) {
            throw of.failure("has a data URI that is no base64: " + Plain.excerpt(e.getMessage()));
        }
    }

    /** The name of a file in a URI: bytes written as %20 are what they stand for. */
    static String decoded(String uri) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        byte[] in = uri.getBytes(StandardCharsets.UTF_8);
        for (int i = 0; i < in.length; i++) {
            int high = i + 2 < in.length ? Character.digit(in[i + 1], 16) : -1;
            int low = i + 2 < in.length ? Character.digit(in[i + 2], 16) : -1;
            if (in[i] == '%' && high >= 0 && low >= 0) {
                out.write(16 * high + low);
                i += 2;
            } else {
                out.write(in[i]);
            }
        }
        return out.toString(StandardCharsets.UTF_8);
    }
}
