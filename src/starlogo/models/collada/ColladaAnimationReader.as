package starlogo.models.collada
{
    import starlogo.models.animation.AnimationChannel;
    import starlogo.models.animation.FileAnimation;
    import starlogo.models.files.ModelFile;
    import starlogo.models.scene.Scene;
    import starlogo.steps.finish;

    /**
     * Reads the animations of a COLLADA document. They move the numbers of elements. An element's target is its <code>ColladaElement.index</code>.
     *
     * @private
     */
    public final class ColladaAnimationReader
    {
        /**
         * Reads the animations.
         *
         * @param name the model's name
         * @param text the document's text
         * @param upAxis as for ColladaReader
         * @throws ModelError if the document is wrong
         */
        public static function allIn(name:String, text:String, upAxis:Object):Vector.<FileAnimation>
        {
            var reader:ColladaReader = new ColladaReader(new ModelFile(name, null, text), upAxis, null);
            var scene:Scene = reader.scene;
            var read:Object = {};
            finish(reader.xml);
            scene.budget.reset();
            var animations:Vector.<FileAnimation> = new Vector.<FileAnimation>();
            var all:Vector.<ColladaElement> = reader.entriesOf("library_animations", "animation");
            var clips:Vector.<ColladaElement> = reader.entriesOf("library_animation_clips", "animation_clip");
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
                    var found:AnimationChannel = read[channel.index] = isRead ? read[channel.index] : ColladaChannel.read(channel);
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
    }
}
