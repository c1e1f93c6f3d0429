package starlogo.models.collada
{
    import starlogo.models.building.shortened;

    /** Which numbers of a COLLADA document move, and how: a channel of an animation. */
    internal final class ColladaChannel
    {
        // An id, the sids of elements within it, and one or two indices. In place of the indices, the last sid may end with a member's name.
        private static const TARGET:RegExp = /^([^\/(]+)((?:\/[^\/(]+)*)(?:\((\d+)\)(?:\((\d+)\))?)?$/;
        private static const WITH_MEMBER:RegExp = /^(.+)\.(\w+)$/;
        private static const MEMBERS:Array = ["X", "Y", "Z", "ANGLE"];
        private static const MATRIX:int = 16;

        /** The element whose numbers move. Null if they move no vertex: those of lights, cameras or materials. */
        public var element:ColladaElement;

        /** How many numbers the element has. */
        public var size:int;

        /** The index of the first number that moves. */
        public var first:int = 0;

        /** How the numbers move. */
        public var sampler:ColladaSampler;

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
            // a dot may also be in a sid
            element = sids.length == 0 || channel.hasSid(sids[sids.length - 1]) ? elementAt(channel, parts[1], sids) : null;
            var ending:Array = element != null || sids.length == 0 ? null : WITH_MEMBER.exec(sids.pop());
            if (ending != null)
            {
                element = elementAt(channel, parts[1], sids.concat(ending[1]));
            }
            size = element == null ? 0 : sizeOf(element);
            if (size == 0)
            {
                element = null;
                return;
            }
            sampler = new ColladaSampler(channel.target("source", ["sampler"], channel.parent));
            var isWhole:Boolean = ending == null && !parts[3];
            // an index may be larger than an int
            var index:Number = isWhole ? 0 : indexOf(ending == null ? null : ending[2], parts[3], parts[4]);
            channel.refuseIf(!(index >= 0 && index < size), "there is no such number in the <" + element.name + ">");
            first = index;
            channel.refuseIf(sampler.width != (isWhole ? size : 1), "its sampler has " + sampler.width + " numbers for each key, but expected " +
                    (isWhole ? size : 1));
        }

        // The element with an id, and the element in it that a list of sids leads to. Null if the id is not that of a scene, a node or an array, or
        // if there is no element with a sid.
        private static function elementAt(channel:ColladaElement, id:String, sids:Array):ColladaElement
        {
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

        // The index of a number. Of a matrix, whose numbers are in rows, the first index is the column. -1 if there is none.
        private function indexOf(member:String, index:String, second:String):Number
        {
            if (member)
            {
                return size > 4 ? -1 : MEMBERS.indexOf(member);
            }
            return second ? (size == MATRIX && Number(index) < 4 ? Number(index) + 4 * Number(second) : -1) : Number(index);
        }
    }
}
