package support
{
    import flash.geom.Vector3D;
    import flash.utils.getQualifiedClassName;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;

    /**
     * What a sequence of calls returned and threw, line by line, so that the same calls on two classes of the same name can be
     * compared. Objects are taken down by what they hold, whatever their classes.
     */
    public class Transcript
    {
        private var _labels:Vector.<String> = new Vector.<String>();
        private var _entries:Array = [];
        private var _thrown:int = 0;

        /** How many calls threw. */
        public function get thrown():int
        {
            return _thrown;
        }

        /** How many lines there are. */
        public function get length():int
        {
            return _entries.length;
        }

        /** Takes a value down. */
        public function note(label:String, value:*):void
        {
            _labels.push(label);
            _entries.push(contents(value));
        }

        /** Calls a function and takes down what it returns, or the class of what it throws. */
        public function attempt(label:String, call:Function):void
        {
            try
            {
                note(label, call());
            }
            catch (error:Error)
            {
                _thrown++;
                note(label, "throws " + getQualifiedClassName(error));
            }
        }

        /**
         * Fails where another transcript differs.
         *
         * @param tolerance how far numbers may be apart, as a part of the larger or of 1
         */
        public function assertAlike(other:Transcript, tolerance:Number = 0):void
        {
            for (var i:int = 0; i < Math.min(length, other.length); i++)
            {
                assertEquals("call " + i, _labels[i], other._labels[i]);
                var ours:Array = _entries[i];
                var theirs:Array = other._entries[i];
                var isSame:Boolean = ours.length == theirs.length;
                for (var k:int = 0; isSame && k < ours.length; k++)
                {
                    isSame = areAlike(ours[k], theirs[k], tolerance);
                }
                assertTrue("call " + i + ", " + _labels[i] + ": " + ours + " and " + theirs, isSame);
            }
            assertEquals("lines", length, other.length);
        }

        private static function areAlike(a:*, b:*, tolerance:Number):Boolean
        {
            if (!(a is Number && b is Number))
            {
                return a === b;
            }
            var isSame:Boolean = a == b || (isNaN(a) && isNaN(b));
            return isSame || Math.abs(a - b) <= tolerance * Math.max(1, Math.abs(a), Math.abs(b));
        }

        private static function contents(value:*):Array
        {
            if (value == null || value is Number || value is String || value is Boolean)
            {
                return [value];
            }
            if (value is Vector.<Number> || value is Array)
            {
                return Array.prototype.concat.apply([], mapped(value, contents));
            }
            switch (getQualifiedClassName(value).split("::").pop())
            {
                case "Vector3D":
                    return [value.x, value.y, value.z, value.w];
                case "Matrix3D":
                    return contents(value.rawData);
                default:
                    return value is Function ? ["a function"] : contents(mapped(value, contents));
            }
        }

        private static function mapped(list:*, change:Function):Array
        {
            var changed:Array = [];
            for (var i:int = 0; i < list.length; i++)
            {
                changed.push(change(list[i]));
            }
            return changed;
        }
    }
}
