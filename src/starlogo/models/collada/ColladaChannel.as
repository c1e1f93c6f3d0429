package starlogo.models.collada
{
    import starlogo.models.files.shortened;

    /** A channel of a COLLADA animation: which numbers of the document move, and how. */
    internal final class ColladaChannel
    {
        // A target is the id of an element, the sids of elements within it, and one or two indices of a number. "node/matrix(3)(0)" is one.
        private static const TARGET:RegExp = /^([^\/(]+)((?:\/[^\/(]+)*)(?:\((\d+)\)(?:\((\d+)\))?)?$/;

        // In place of indices, the last sid may end with the name of a number: "node/translate.X".
        private static const WITH_NAME:RegExp = /^(.+)\.(\w+)$/;
        private static const NUMBER_NAMES:Array = ["X", "Y", "Z", "ANGLE"];
        private static const WITH_NAMED_NUMBERS:Array = ["translate", "scale", "rotate"];
        private static const MATRIX_COLUMNS:int = 4;

        /** The element whose numbers move. Null if they move no vertex: those of lights, cameras or materials. */
        public var element:ColladaElement;

        /** The index of the first number that moves. */
        public var first:int = 0;

        /** How the numbers move. */
        public var sampler:ColladaSampler;

        // How many numbers the element has. 0 if they move no vertex.
        private var _size:int = 0;

        /**
         * @param channel the channel's element
         * @throws ModelError if its target or its sampler is wrong
         */
        public function ColladaChannel(channel:ColladaElement)
        {
            var target:String = channel.attribute("target");
            var parts:Array = TARGET.exec(target);
            channel.refuseIf(parts == null, "expected a target like \"node/translate.X\", but found \"" + shortened(target) + "\"");
            var sids:Array = parts[2].split("/").slice(1);
            var named:Array = null;
            element = elementAt(channel, parts[1], sids);
            if (element == null && sids.length > 0)
            {
                // without an element of this sid, the dot in it is before a name
                named = WITH_NAME.exec(sids.pop());
                element = named == null ? null : elementAt(channel, parts[1], sids.concat(named[1]));
            }
            _size = element == null ? 0 : sizeOf(element);
            if (_size == 0)
            {
                element = null;
                return;
            }
            sampler = new ColladaSampler(channel.target("source", ["sampler"], channel.parent));
            var movesAll:Boolean = named == null && !parts[3];
            // an index may be larger than an int
            var index:Number = movesAll ? 0 : (named == null ? indexAt(parts[3], parts[4]) : indexNamed(named[2]));
            var width:int = movesAll ? _size : 1;
            channel.refuseIf(!(index >= 0 && index < _size), "there is no such number in the <" + element.name + ">");
            channel.refuseIf(sampler.width != width, "its sampler has " + sampler.width + " numbers for each key, but expected " + width);
            first = index;
        }

        /** All numbers of the element, as the document has them. */
        public function numbersAtRest():Vector.<Number>
        {
            return element.numbers(_size);
        }

        // The element with an id, and the element in it that a list of sids leads to. Null if the id is not that of a scene, a node or an array, or
        // if there is no element with a sid.
        private static function elementAt(channel:ColladaElement, id:String, sids:Array):ColladaElement
        {
            if (sids.length > 0 && !channel.hasSid(sids[sids.length - 1]))
            {
                return null;
            }
            var source:ColladaElement = channel.elementWith("source", id);
            var found:ColladaElement = channel.elementWith("node", id) || channel.elementWith("visual_scene", id)
                || channel.elementWith("float_array", id) || (source == null ? null : source.child("float_array"));
            for (var i:int = 0; i < sids.length && found != null; i++)
            {
                found = inside(channel, found, sids[i]);
            }
            return found;
        }

        // The element with a sid in another one, nearest to it. Null if there is none: some programs move what a node does not have, such as its
        // visibility.
        private static function inside(channel:ColladaElement, around:ColladaElement, sid:String):ColladaElement
        {
            var pending:Vector.<ColladaElement> = new <ColladaElement>[around];
            for (var i:int = 0; i < pending.length; i++)
            {
                channel.limits.countElements(pending[i].children.length, channel);
                for each (var child:ColladaElement in pending[i].children)
                {
                    if (child.attribute("sid") == sid)
                    {
                        return child;
                    }
                    pending.push(child);
                }
            }
            return null;
        }

        private static function sizeOf(element:ColladaElement):int
        {
            return element.name == "float_array" ? element.countedWords().length : ColladaTransform.sizeOf(element.name);
        }

        // The index of a number with a name. -1 if there is none.
        private function indexNamed(name:String):int
        {
            return WITH_NAMED_NUMBERS.indexOf(element.name) < 0 ? -1 : NUMBER_NAMES.indexOf(name);
        }

        // The index of a number at one or two indices; the second is null if there is one. Only a matrix has two: of a column, and of a row. Its
        // numbers are in rows. -1 if there is no such number.
        private function indexAt(index:String, row:String):Number
        {
            if (!row)
            {
                return Number(index);
            }
            return element.name == "matrix" && Number(index) < MATRIX_COLUMNS ? Number(index) + MATRIX_COLUMNS * Number(row) : -1;
        }
    }
}
