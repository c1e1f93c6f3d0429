package starlogo.models.cooked
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.engine;
    import starlogo.models.Model;
    import starlogo.models.ModelTransform;
    import starlogo.models.SourceFrame;

    use namespace engine;

    /**
     * Writes a model for a CookedReader: the vertices of its source in the shortest form that gives back the model's to the last bit.
     *
     * @private
     */
    public final class CookedShape
    {
        /** How vertices are written besides as whole multiples of a power of 1/10, whose exponent is smaller: in 32 bits. */
        internal static const SINGLE:int = 9;

        /** In 64 bits, and as the model has them. */
        internal static const DOUBLE:int = 10;

        private static const LARGEST:Number = 1000000000;

        /** All is static. */
        public function CookedShape()
        {
        }

        /** The section of a model. */
        public static function of(model:Model):ByteArray
        {
            var source:Vector.<Number> = model.source.pointsOf(model.vertices);
            for (var form:int = 0; form <= SINGLE; form++)
            {
                var points:Vector.<Number> = new Vector.<Number>();
                for each (var value:Number in source)
                {
                    points.push(nearest(value, form));
                }
                if (model.isMadeOf(points))
                {
                    return write(model, form, points);
                }
            }
            return write(model, DOUBLE, model.vertices);
        }

        /** What the numbers of a form are to be divided by. */
        internal static function divisorOf(form:int):Number
        {
            var divisor:Number = 1;
            for (var i:int = 0; i < form && form < SINGLE; i++)
            {
                divisor *= 10;
            }
            return divisor;
        }

        // Of the numbers that a form has.
        private static function nearest(value:Number, form:int):Number
        {
            if (form < SINGLE)
            {
                var multiple:Number = multipleOf(value, form);
                return Math.abs(multiple) < LARGEST ? multiple / divisorOf(form) : 0;
            }
            var bytes:ByteArray = new ByteArray();
            bytes.writeFloat(value);
            bytes.position = 0;
            var single:Number = bytes.readFloat();
            return isFinite(single) ? single : 0;
        }

        private static function multipleOf(value:Number, form:int):Number
        {
            return Math.round(value * divisorOf(form));
        }

        private static function write(model:Model, form:int, numbers:Vector.<Number>):ByteArray
        {
            var frame:SourceFrame = model.source;
            var transform:ModelTransform = form == DOUBLE ? null : frame.transform;
            var out:ByteArray = CookedFile.newBytes();
            var triangleCount:int = model.triangles == null ? 0 : model.triangles.length / 3;
            for each (var count:int in [Model.SCALINGS.indexOf(frame.scaling), form, transform == null ? 0 : 1, numbers.length / 3, triangleCount])
            {
                CookedNumbers.write(count, out);
            }
            for each (var vector:Vector3D in transform == null ? [] : [transform.rotation, transform.scale, transform.translation])
            {
                CookedNumbers.writeVector(vector, out);
            }
            if (form == DOUBLE)
            {
                frame.writeTo(out);
            }
            for (var i:int = 0; i < numbers.length; i++)
            {
                writeNumber(numbers[i], i < 3 ? 0 : numbers[i - 3], form, out);
            }
            for (i = 0; i < 3 * triangleCount; i++)
            {
                writeNumber(model.triangles[i], i == 0 ? 0 : model.triangles[i - 1], 0, out);
            }
            return out;
        }

        private static function writeNumber(value:Number, before:Number, form:int, out:ByteArray):void
        {
            switch (form)
            {
                case SINGLE:
                    out.writeFloat(value);
                    break;
                case DOUBLE:
                    out.writeDouble(value);
                    break;
                default:
                    CookedNumbers.write(multipleOf(value, form) - multipleOf(before, form), out);
            }
        }
    }
}
