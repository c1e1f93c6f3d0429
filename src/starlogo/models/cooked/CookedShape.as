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
        private static const MOST_DECIMALS:int = 8;
        private static const LARGEST:Number = 1000000000;
        private static const LARGEST_SHORT:int = 32767;

        // how far numbers of the source may be from what the model's say, in proportion to the largest
        private static const ROUNDING:Number = 1e-11;

        /** All is static. */
        public function CookedShape()
        {
        }

        /** The section of a model. */
        public static function of(model:Model):ByteArray
        {
            var source:Vector.<Number> = model.source.pointsOf(model.vertices);
            for (var form:int = 0; form <= MOST_DECIMALS; form++)
            {
                var multiples:Vector.<Number> = multiplesIn(source, CookedReader.divisorOf(form));
                if (multiples != null && isMadeOf(model, multiples, CookedReader.divisorOf(form)))
                {
                    return write(model, form, differences(multiples, 3));
                }
            }
            var single:Vector.<Number> = rounded(source);
            return isMadeOf(model, single, 1) ? write(model, CookedReader.SINGLE, single) : write(model, CookedReader.DOUBLE, model.vertices);
        }

        // null if they are none
        private static function multiplesIn(source:Vector.<Number>, divisor:Number):Vector.<Number>
        {
            var largest:Number = 0;
            var apart:Number = 0;
            var multiples:Vector.<Number> = new Vector.<Number>();
            for each (var value:Number in source)
            {
                var multiple:Number = Math.round(value * divisor);
                largest = Math.max(largest, Math.abs(multiple));
                apart = Math.max(apart, Math.abs(value * divisor - multiple));
                multiples.push(multiple);
            }
            return largest < LARGEST && apart <= ROUNDING * (1 + largest) ? multiples : null;
        }

        private static function rounded(source:Vector.<Number>):Vector.<Number>
        {
            var single:ByteArray = CookedFile.newBytes();
            var all:Vector.<Number> = new Vector.<Number>();
            for each (var value:Number in source)
            {
                single.position = 0;
                single.writeFloat(value);
                single.position = 0;
                all.push(single.readFloat());
            }
            return all;
        }

        private static function isMadeOf(model:Model, multiples:Vector.<Number>, divisor:Number):Boolean
        {
            var points:Vector.<Number> = new Vector.<Number>();
            for each (var multiple:Number in multiples)
            {
                points.push(multiple / divisor);
            }
            return model.isMadeOf(points);
        }

        private static function differences(values:Vector.<Number>, stride:int):Vector.<Number>
        {
            var all:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < values.length; i++)
            {
                all.push(i < stride ? values[i] : values[i] - values[i - stride]);
            }
            return all;
        }

        private static function areShort(values:Vector.<Number>):Boolean
        {
            for each (var value:Number in values)
            {
                if (Math.abs(value) > LARGEST_SHORT)
                {
                    return false;
                }
            }
            return true;
        }

        private static function write(model:Model, form:int, numbers:Vector.<Number>):ByteArray
        {
            var isGiven:Boolean = form == CookedReader.DOUBLE;
            var frame:SourceFrame = model.source;
            var transform:ModelTransform = isGiven ? null : frame.transform;
            var corners:Vector.<Number> = new Vector.<Number>();
            for each (var corner:uint in model.triangles)
            {
                corners.push(corner);
            }
            corners = differences(corners, 1);
            var isShort:Boolean = form < CookedReader.SINGLE && areShort(numbers);
            var isShortIndex:Boolean = areShort(corners);
            var out:ByteArray = CookedFile.newBytes();
            out.writeInt(isShort ? 1 : 0);
            out.writeInt(isShortIndex ? 1 : 0);
            out.writeInt(transform == null ? 0 : 1);
            out.writeInt(isGiven ? 1 : 0);
            out.writeInt(Model.SCALINGS.indexOf(isGiven ? Model.AS_GIVEN : frame.scaling));
            out.writeInt(form);
            out.writeInt(numbers.length / 3);
            out.writeInt(corners.length / 3);
            for each (var vector:Vector3D in transform == null ? [] : [transform.rotation, transform.scale, transform.translation])
            {
                out.writeDouble(vector.x);
                out.writeDouble(vector.y);
                out.writeDouble(vector.z);
            }
            if (isGiven)
            {
                frame.writeTo(out);
            }
            for each (var value:Number in numbers)
            {
                writeNumber(value, isShort ? -1 : form, out);
            }
            for each (value in corners)
            {
                writeNumber(value, isShortIndex ? -1 : 0, out);
            }
            return out;
        }

        private static function writeNumber(value:Number, form:int, out:ByteArray):void
        {
            switch (form)
            {
                case -1:
                    out.writeShort(value);
                    break;
                case CookedReader.SINGLE:
                    out.writeFloat(value);
                    break;
                case CookedReader.DOUBLE:
                    out.writeDouble(value);
                    break;
                default:
                    out.writeInt(value);
            }
        }
    }
}
