package starlogo.models.collada
{
    import starlogo.models.animation.AnimationChannel;
    import starlogo.models.animation.AnimationSampler;
    import starlogo.models.animation.FileAnimation;
    import starlogo.models.files.ModelFile;
    import starlogo.models.files.shortened;
    import starlogo.models.text.TextWords;
    import starlogo.steps.finish;

    /**
     * Reads the animations of a COLLADA document. They move the numbers of elements. An element's target is its <code>ColladaElement.index</code>.
     *
     * @private
     */
    public final class ColladaAnimationReader
    {
        // A target is the id of an element, the sids of elements within it, and one or two indices of a number. "node/matrix(3)(0)" is one.
        private static const TARGET:RegExp = /^([^\/(]+)((?:\/[^\/(]+)*)(?:\((\d+)\)(?:\((\d+)\))?)?$/;

        // In place of indices, the last sid may end with the name of a number: "node/translate.X".
        private static const WITH_NAME:RegExp = /^(.+)\.(\w+)$/;
        private static const NUMBER_NAMES:Array = ["X", "Y", "Z", "ANGLE"];
        private static const WITH_NAMED_NUMBERS:Array = ["translate", "scale", "rotate"];
        private static const MATRIX_COLUMNS:int = 4;

        private static const BEZIER:String = "BEZIER";

        /**
         * Reads the animations.
         *
         * @param name the model's name
         * @param text the document's text
         * @param upAxis as for ColladaScene
         * @throws ModelError if the document is wrong
         */
        public static function allIn(name:String, text:String, upAxis:Object):Vector.<FileAnimation>
        {
            var scene:ColladaScene = new ColladaScene(new ModelFile(name, null, text), upAxis, null);
            var read:Object = {};
            finish(scene.xml);
            scene.budget.reset();
            var animations:Vector.<FileAnimation> = new Vector.<FileAnimation>();
            var all:Vector.<ColladaElement> = scene.entriesOf("library_animations", "animation");
            var clips:Vector.<ColladaElement> = scene.entriesOf("library_animation_clips", "animation_clip");
            for each (var clip:ColladaElement in clips)
            {
                var parts:Vector.<ColladaElement> = new Vector.<ColladaElement>();
                for each (var part:ColladaElement in clip.childrenNamed("instance_animation"))
                {
                    parts.push(part.target("url", ["animation"]));
                }
                var start:Number = clip.toNumber(clip.attribute("start") || "0");
                var end:Number = clip.attribute("end") == "" ? NaN : clip.toNumber(clip.attribute("end"));
                clip.refuseIf(end < start, "it ends before it starts");
                animations.push(new FileAnimation(clip.attribute("name") || clip.id, channelsOf(parts, read), scene, start, end));
            }
            if (clips.length == 0 && all.length > 0)
            {
                animations.push(new FileAnimation("", channelsOf(all, read), scene));
            }
            if (animations.length > 0)
            {
                scene.budget.reset();
                finish(scene);
            }
            return animations;
        }

        // The channels of some animations, and of those within them. A channel is read once, even if several clips have it.
        // @param read the channels that are read so far, by the index of their elements
        private static function channelsOf(elements:Vector.<ColladaElement>, read:Object):Vector.<AnimationChannel>
        {
            var channels:Vector.<AnimationChannel> = new Vector.<AnimationChannel>();
            var pending:Vector.<ColladaElement> = elements.slice().reverse();
            while (pending.length > 0)
            {
                var element:ColladaElement = pending.pop();
                element.budget.spendElements(1 + element.children.length, element);
                for each (var channel:ColladaElement in element.childrenNamed("channel"))
                {
                    var isRead:Boolean = channel.index in read;
                    var found:AnimationChannel = read[channel.index] = isRead ? read[channel.index] : channelOf(channel);
                    if (found != null)
                    {
                        channels.push(found);
                    }
                }
                for each (var inner:ColladaElement in element.childrenNamed("animation").reverse())
                {
                    pending.push(inner);
                }
            }
            return channels;
        }

        // Reads a channel. Returns null if it moves no vertex: if it moves numbers of lights, cameras or materials.
        private static function channelOf(channel:ColladaElement):AnimationChannel
        {
            var target:String = channel.attribute("target");
            var parts:Array = TARGET.exec(target);
            channel.refuseIf(parts == null, "expected a target like \"node/translate.X\", but found \"" + shortened(target) + "\"");
            var sids:Array = parts[2].split("/").slice(1);
            var named:Array = null;
            var element:ColladaElement = animatedElement(channel, parts[1], sids);
            if (element == null && sids.length > 0)
            {
                // without an element of this sid, the dot in it is before a name
                named = WITH_NAME.exec(sids.pop());
                element = named == null ? null : animatedElement(channel, parts[1], sids.concat(named[1]));
            }
            var size:int = movableCount(element);
            if (size == 0)
            {
                return null;
            }
            var sampler:AnimationSampler = samplerOf(channel.target("source", ["sampler"], channel.parent));
            var movesAll:Boolean = named == null && !parts[3];
            // an index may be larger than an int
            var index:Number = movesAll ? 0 : (named == null ? indexAt(element, parts[3], parts[4]) : indexNamed(element, named[2]));
            var width:int = movesAll ? size : 1;
            channel.refuseIf(!(index >= 0 && index < size), "there is no such number in the <" + element.name + ">");
            channel.refuseIf(sampler.componentCount != width, "its sampler has " + sampler.componentCount + " numbers for each key, but expected " + width);
            return new AnimationChannel(sampler, String(element.index), element.numbers(size), index);
        }

        // How many numbers of an element can move; 0 for null, and for an element of another kind.
        private static function movableCount(element:ColladaElement):int
        {
            var isArray:Boolean = element != null && element.name == "float_array";
            return isArray ? TextWords.of(element.countedText()).length : (element == null ? 0 : ColladaTransform.sizeOf(element.name));
        }

        // The element with an id, and the element in it that a list of sids leads to. Null if the id is not that of a scene, a node or an array, or
        // if there is no element with a sid.
        private static function animatedElement(channel:ColladaElement, id:String, sids:Array):ColladaElement
        {
            if (sids.length > 0 && !channel.hasSid(sids[sids.length - 1]))
            {
                return null;
            }
            var source:ColladaElement = channel.elementAt("source", "#" + id);
            var found:ColladaElement = channel.elementAt("node", "#" + id) || channel.elementAt("visual_scene", "#" + id)
                || channel.elementAt("float_array", "#" + id) || (source == null ? null : source.child("float_array"));
            for (var i:int = 0; i < sids.length && found != null; i++)
            {
                found = descendantWithSid(channel, found, sids[i]);
            }
            return found;
        }

        // The element with a sid in another one, nearest to it. Null if there is none: some programs move what a node does not have, such as its
        // visibility.
        private static function descendantWithSid(channel:ColladaElement, around:ColladaElement, sid:String):ColladaElement
        {
            var pending:Vector.<ColladaElement> = new <ColladaElement>[around];
            for (var i:int = 0; i < pending.length; i++)
            {
                channel.budget.spendElements(pending[i].children.length, channel);
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

        // The index of a number with a name. -1 if there is none.
        private static function indexNamed(element:ColladaElement, name:String):int
        {
            return WITH_NAMED_NUMBERS.indexOf(element.name) < 0 ? -1 : NUMBER_NAMES.indexOf(name);
        }

        // The index of a number at one or two indices; the second is null if there is one. Only a matrix has two: of a column, and of a row. Its
        // numbers are in rows. -1 if there is no such number.
        private static function indexAt(element:ColladaElement, index:String, row:String):Number
        {
            if (!row)
            {
                return Number(index);
            }
            return element.name == "matrix" && Number(index) < MATRIX_COLUMNS ? Number(index) + MATRIX_COLUMNS * Number(row) : -1;
        }

        // Reads the keys of a sampler.
        private static function samplerOf(sampler:ColladaElement):AnimationSampler
        {
            var times:Vector.<Number> = listOf(sampler, "INPUT", ColladaAccessor.NUMBERS).toNumbers();
            var values:ColladaAccessor = listOf(sampler, "OUTPUT", ColladaAccessor.NUMBERS, times.length);
            var interpolations:Array = [AnimationSampler.LINEAR];
            if (sampler.child("input", "INTERPOLATION") != null)
            {
                var list:ColladaAccessor = listOf(sampler, "INTERPOLATION", ColladaAccessor.NAMES, times.length);
                sampler.refuseIf(list.stride != 1, "expected one interpolation for each key");
                interpolations = list.words;
            }
            var known:Array = [AnimationSampler.LINEAR, AnimationSampler.STEP, BEZIER];
            for each (var name:String in interpolations)
            {
                if (known.indexOf(name) < 0)
                {
                    throw sampler.error("expected LINEAR, STEP or BEZIER, but found \"" + shortened(name) + "\"");
                }
            }
            var hasCurves:Boolean = interpolations.indexOf(BEZIER) >= 0;
            var outControls:ColladaAccessor = hasCurves ? controlPoints(sampler, "OUT_TANGENT", values) : null;
            var inControls:ColladaAccessor = hasCurves ? controlPoints(sampler, "IN_TANGENT", values) : null;
            sampler.refuseIf(hasCurves && inControls.stride != outControls.stride, "its tangents are of different kinds");
            return new AnimationSampler(sampler.budget.modelName, sampler, times, values.toNumbers(), interpolations, hasCurves ? outControls.toNumbers() : null,
                    hasCurves ? inControls.toNumbers() : null);
        }

        // A control point has a time and a value for each number, or the value alone.
        private static function controlPoints(sampler:ColladaElement, semantic:String, values:ColladaAccessor):ColladaAccessor
        {
            var list:ColladaAccessor = listOf(sampler, semantic, ColladaAccessor.NUMBERS, values.count);
            sampler.refuseIf(list.stride != values.stride && list.stride != 2 * values.stride, "expected " + values.stride + " or " + 2 * values.stride +
                    " numbers in each " + semantic + ", but found " + list.stride);
            return list;
        }

        // The entries of an input. @param keyCount how many there must be; -1 for any number
        private static function listOf(sampler:ColladaElement, semantic:String, arrays:Array, keyCount:int = -1):ColladaAccessor
        {
            var list:ColladaAccessor = ColladaAccessor.read(sampler, semantic, arrays, sampler.parent);
            sampler.refuseIf(keyCount >= 0 && (list.count != keyCount || keyCount == 0), "expected as many of " + semantic +
                    " as of INPUT, at least one, but found " + list.count + " and " + keyCount);
            return list;
        }
    }
}
