package enlightenment.net.protocol;

import enlightenment.file.ContentHash;
import java.io.ByteArrayOutputStream;
import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import tools.jackson.core.JacksonException;
import tools.jackson.core.JsonGenerator;
import tools.jackson.core.JsonParser;
import tools.jackson.core.JsonToken;
import tools.jackson.core.ObjectReadContext;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.StreamReadConstraints;
import tools.jackson.core.exc.StreamConstraintsException;
import tools.jackson.dataformat.cbor.CBORFactory;

/**
 * Messages as CBOR (RFC 8949). The components of the records are the format: their number and types are read off the
 * records once, so that a message is declared in one place only. Strict: another number of fields, another type, a value
 * that the record refuses or a byte too many is a {@link ProtocolException}.
 *
 * <p>Bodies are complete byte arrays of a bounded length, and nothing is allocated by a length that they claim beyond
 * what they contain but a quarter of a MiB (the largest piece that the CBOR parser reads at once).
 */
final class MessageCodec {
    private static final CBORFactory FACTORY = CBORFactory.builder()
            .streamReadConstraints(StreamReadConstraints.builder()
                    .maxNestingDepth(Limits.NESTING)
                    .maxStringLength(Limits.FRAME)
                    .maxNumberLength(32)
                    .maxDocumentLength(Limits.FRAME)
                    .maxTokenCount(Limits.TOKENS)
                    .build())
            .build();

    private static final List<Shape> SHAPES =
            Message.KINDS.stream().map(Shape::of).toList();

    private static final Map<Class<?>, Shape> BY_CLASS = byClass();

    private MessageCodec() {}

    /** One kind of message: its number and what its record is made of. */
    private record Shape(int kind, RecordComponent[] components, Constructor<?> constructor) {
        static Shape of(Class<? extends Message> type) {
            RecordComponent[] components = type.getRecordComponents();
            Class<?>[] types = new Class<?>[components.length];
            for (int i = 0; i < types.length; i++) {
                types[i] = components[i].getType();
            }
            try {
                Constructor<?> constructor = type.getDeclaredConstructor(types);
                return new Shape(Message.KINDS.indexOf(type) + 1, components, constructor);
            } catch (NoSuchMethodException e) {
                throw new IllegalStateException("a record has a canonical constructor", e);
            }
        }
    }

    private static Map<Class<?>, Shape> byClass() {
        Map<Class<?>, Shape> map = new HashMap<>();
        for (Shape shape : SHAPES) {
            map.put(Message.KINDS.get(shape.kind - 1), shape);
        }
        return Map.copyOf(map);
    }

    /** The message as a frame body. */
    static byte[] encode(Message message) {
        Shape shape = BY_CLASS.get(message.getClass());
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JsonGenerator out = FACTORY.createGenerator(ObjectWriteContext.empty(), bytes)) {
            out.writeStartArray(null, shape.components.length + 1);
            out.writeNumber(shape.kind);
            for (RecordComponent component : shape.components) {
                write(out, component.getAccessor().invoke(message));
            }
            out.writeEndArray();
        } catch (IllegalAccessException | InvocationTargetException e) {
            throw new IllegalStateException("a record's accessor failed", e);
        }
        return bytes.toByteArray();
    }

    private static void write(JsonGenerator out, Object value) {
        if (value instanceof Integer number) {
            out.writeNumber(number);
        } else if (value instanceof Long number) {
            out.writeNumber(number);
        } else if (value instanceof Boolean flag) {
            out.writeBoolean(flag);
        } else if (value instanceof String text) {
            out.writeString(text);
        } else if (value instanceof byte[] bytes) {
            out.writeBinary(bytes);
        } else if (value instanceof ContentHash hash) {
            out.writeBinary(hash.toBytes());
        } else if (value instanceof List<?> list) {
            out.writeStartArray(null, list.size());
            list.forEach(element -> write(out, element));
            out.writeEndArray();
        } else {
            throw new IllegalStateException("no way to write a " + value.getClass());
        }
    }

    /** The message that a frame body is. */
    static Message decode(byte[] body) throws ProtocolException {
        try (JsonParser in = FACTORY.createParser(ObjectReadContext.empty(), body)) {
            expect(in, in.nextToken(), JsonToken.START_ARRAY, "an array");
            int kind = (int) number(in, in.nextToken(), 1, Integer.MAX_VALUE);
            if (kind > SHAPES.size()) {
                throw new ProtocolException("message of unknown kind " + kind);
            }
            Message message = read(in, SHAPES.get(kind - 1));
            expect(in, in.nextToken(), JsonToken.END_ARRAY, "the end of the message");
            if (in.nextToken() != null) {
                throw new ProtocolException("something follows the end of the message");
            }
            return message;
        } catch (StreamConstraintsException e) {
            throw new ProtocolException("message beyond the limits: " + e.getOriginalMessage(), e);
        } catch (JacksonException e) {
            throw new ProtocolException("message is not CBOR: " + e.getOriginalMessage(), e);
        } catch (RuntimeException e) {
            // Whatever else a parser may stumble over in bytes that a stranger chose must not end the server.
            throw new ProtocolException("message cannot be read: " + e, e);
        }
    }

    private static Message read(JsonParser in, Shape shape) throws ProtocolException {
        Object[] values = new Object[shape.components.length];
        String name = Message.KINDS.get(shape.kind - 1).getSimpleName();
        try {
            for (int i = 0; i < values.length; i++) {
                values[i] = readValue(in, shape.components[i]);
            }
            return (Message) shape.constructor.newInstance(values);
        } catch (ProtocolException e) {
            throw new ProtocolException(name + ": " + e.getMessage(), e);
        } catch (InvocationTargetException e) {
            throw new ProtocolException(name + ": " + e.getCause().getMessage(), e.getCause());
        } catch (InstantiationException | IllegalAccessException e) {
            throw new IllegalStateException("a record's constructor failed", e);
        }
    }

    private static Object readValue(JsonParser in, RecordComponent component) throws ProtocolException {
        if (component.getType() != List.class) {
            return scalar(in, in.nextToken(), component.getType());
        }
        Class<?> element = (Class<?>) ((ParameterizedType) component.getGenericType()).getActualTypeArguments()[0];
        expect(in, in.nextToken(), JsonToken.START_ARRAY, "a list");
        List<Object> list = new ArrayList<>();
        for (JsonToken token = in.nextToken(); token != JsonToken.END_ARRAY; token = in.nextToken()) {
            list.add(scalar(in, token, element));
        }
        return list;
    }

    private static Object scalar(JsonParser in, JsonToken token, Class<?> type) throws ProtocolException {
        if (type == int.class) {
            return (int) number(in, token, Integer.MIN_VALUE, Integer.MAX_VALUE);
        }
        if (type == long.class || type == Long.class) {
            return number(in, token, Long.MIN_VALUE, Long.MAX_VALUE);
        }
        if (type == boolean.class) {
            boolean yes = token == JsonToken.VALUE_TRUE;
            expect(in, token, yes ? JsonToken.VALUE_TRUE : JsonToken.VALUE_FALSE, "yes or no");
            return yes;
        }
        if (type == String.class) {
            expect(in, token, JsonToken.VALUE_STRING, "a text");
            return in.getString();
        }
        expect(in, token, JsonToken.VALUE_EMBEDDED_OBJECT, "bytes");
        byte[] bytes = in.getBinaryValue();
        if (bytes == null) {
            // The parser shows CBOR's "undefined" and unassigned simple values as embedded objects, too.
            throw new ProtocolException("bytes expected, not an undefined value");
        }
        if (type == byte[].class) {
            return bytes;
        }
        if (bytes.length != ContentHash.BYTES) {
            throw new ProtocolException("a hash has " + ContentHash.BYTES + " bytes, not " + bytes.length);
        }
        return ContentHash.fromBytes(bytes);
    }

    private static long number(JsonParser in, JsonToken token, long lowest, long highest) throws ProtocolException {
        expect(in, token, JsonToken.VALUE_NUMBER_INT, "a whole number");
        JsonParser.NumberType type = in.getNumberType();
        boolean fits = type == JsonParser.NumberType.INT || type == JsonParser.NumberType.LONG;
        if (!fits || in.getLongValue() < lowest || in.getLongValue() > highest) {
            throw new ProtocolException("a number is out of range");
        }
        return in.getLongValue();
    }

    private static void expect(JsonParser in, JsonToken token, JsonToken wanted, String what) throws ProtocolException {
        if (token != wanted) {
            String found = token == null ? "the end" : token.toString();
            throw new ProtocolException(what + " expected, not " + found + " (byte "
                    + in.currentLocation().getByteOffset() + ")");
        }
    }
}
