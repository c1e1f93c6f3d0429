package starlogo.models.cooked
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.data.areSameNumbers;
    import starlogo.engine;
    import starlogo.models.Model;
    import starlogo.models.ModelTransform;
    import starlogo.models.building.ModelBuilder;
    import starlogo.models.building.ModelData;
    import starlogo.models.building.TriangleLabels;
    import starlogo.models.files.refuseModelIf;

    use namespace engine;

    /**
     * Writes a model for a CookedReader. It computes the source's vertices from the model's, and writes them with the fewest decimals that
     * restore the model to the last bit, or as floats of 32 bits if these do. If nothing does, it writes the model's own vertices.
     *
     * @private
     */
    public final class CookedWriter
    {
        private static const LARGEST:Number = 1000000000;

        /** The bytes of a model's section. @throws ModelError if it needs the model's place in its source, which is not finite */
        public static function write(model:Model):ByteArray
        {
            var source:Vector.<Number> = model.source.toSource(model.vertices);
            var transform:ModelTransform = model.data.transform;
            // a transform that mirrors would turn the triangles over once more
            var isMirror:Boolean = transform != null && transform.isMirror;
            for (var encoding:int = 0; encoding <= CookedReader.SOURCE_FLOAT && !isMirror; encoding++)
            {
                var points:Vector.<Number> = rounded(source, encoding);
                if (areSourceOf(points, model, transform))
                {
                    return writeAs(model, encoding, points, transform);
                }
            }
            refuseModelIf(!model.source.isValid, model.name, "its place in its source is not finite numbers, so it can't be cooked");
            return writeAs(model, CookedReader.NORMALISED_DOUBLE, model.vertices, null);
        }

        // Whether a model of these points and the model's triangles is the model: the vertices and the place in the source are equal to the last bit.
        private static function areSourceOf(points:Vector.<Number>, model:Model, transform:ModelTransform):Boolean
        {
            var made:ModelData = ModelBuilder.dataOf(model.name, points, model.triangles, model.data.scaling, transform);
            return areSameNumbers(made.vertices, model.vertices) && areSameNumbers(made.source.toNumbers(), model.source.toNumbers());
        }

        // The nearest numbers that an encoding can have.
        private static function rounded(source:Vector.<Number>, encoding:int):Vector.<Number>
        {
            var points:Vector.<Number> = new Vector.<Number>();
            var divisor:Number = CookedReader.divisorOf(encoding);
            var bytes:ByteArray = new ByteArray();
            for each (var value:Number in source)
            {
                bytes.position = 0;
                bytes.writeFloat(value);
                bytes.position = 0;
                var number:Number = encoding <= CookedReader.MOST_DECIMALS ? Math.round(value * divisor) : bytes.readFloat();
                points.push(Math.abs(number) < LARGEST || encoding == CookedReader.SOURCE_FLOAT && isFinite(number) ? number / divisor : 0);
            }
            return points;
        }

        private static function writeAs(model:Model, encoding:int, points:Vector.<Number>, transform:ModelTransform):ByteArray
        {
            var out:ByteArray = CookedFile.newBytes();
            var data:ModelData = model.data;
            var triangles:Vector.<uint> = model.triangles || new Vector.<uint>();
            VarInt.write(Model.SCALINGS.indexOf(data.scaling), out);
            VarInt.write(encoding, out);
            VarInt.write(transform == null ? 0 : 1, out);
            VarInt.write(points.length / 3, out);
            VarInt.write(triangles.length / 3, out);
            if (transform != null)
            {
                writeVector(transform.rotation, out);
                writeVector(transform.scale, out);
                writeVector(transform.translation, out);
            }
            if (encoding == CookedReader.NORMALISED_DOUBLE)
            {
                for each (var number:Number in model.source.toNumbers())
                {
                    out.writeDouble(number);
                }
            }
            writePoints(points, encoding, out);
            for (var i:int = 0; i < triangles.length; i++)
            {
                VarInt.write(triangles[i] - (i == 0 ? 0 : triangles[i - 1]), out);
            }
            if (data.materials.labels != null || data.meshes.labels != null)
            {
                writeLabels(data.materials, out);
                writeLabels(data.meshes, out);
            }
            return out;
        }

        private static function writeVector(vector:Vector3D, out:ByteArray):void
        {
            out.writeDouble(vector.x);
            out.writeDouble(vector.y);
            out.writeDouble(vector.z);
        }

        // Multiples are written as differences from the vertex before.
        private static function writePoints(points:Vector.<Number>, encoding:int, out:ByteArray):void
        {
            var divisor:Number = CookedReader.divisorOf(encoding);
            for (var i:int = 0; i < points.length; i++)
            {
                if (encoding <= CookedReader.MOST_DECIMALS)
                {
                    VarInt.write(Math.round(points[i] * divisor) - (i < 3 ? 0 : Math.round(points[i - 3] * divisor)), out);
                }
                else if (encoding == CookedReader.SOURCE_FLOAT)
                {
                    out.writeFloat(points[i]);
                }
                else
                {
                    out.writeDouble(points[i]);
                }
            }
        }

        // The names, and the runs after the first. The length of a missing name is -1.
        private static function writeLabels(labels:TriangleLabels, out:ByteArray):void
        {
            VarInt.write(labels.names == null ? -1 : labels.names.length, out);
            for each (var name:String in labels.names)
            {
                var bytes:ByteArray = new ByteArray();
                bytes.writeUTFBytes(name || "");
                VarInt.write(name == null ? -1 : bytes.length, out);
                out.writeBytes(bytes);
            }
            VarInt.write(labels.labelsOfRuns.length - 1, out);
            for (var run:int = 1; run < labels.labelsOfRuns.length; run++)
            {
                VarInt.write(labels.firstTriangles[run] - labels.firstTriangles[run - 1], out);
                VarInt.write(labels.labelsOfRuns[run], out);
            }
        }
    }
}
