package starlogo.models.animation
{
    import starlogo.geometry.AffineTransform;
    import starlogo.models.building.ModelData;
    import starlogo.models.scene.Scene;
    import starlogo.steps.finish;

    /**
     * An animation of a model's file. Its channels set the numbers of a pose.
     *
     * @private
     */
    public final class FileAnimation
    {
        /** Its name; "" if it has none. Read only. */
        public var name:String;

        /** Its length, in seconds. 0 without keys. Read only. */
        public var duration:Number;

        private var _channels:Vector.<AnimationChannel>;
        private var _start:Number;
        private var _scene:Scene;

        /**
         * @param name its name; "" if it has none
         * @param channels what moves
         * @param scene moves; read before a pose is asked for
         * @param start when it starts, in the time of the samplers' keys
         * @param end when it ends, in the same time; NaN for the last key
         */
        public function FileAnimation(name:String, channels:Vector.<AnimationChannel>, scene:Scene, start:Number = 0, end:Number = NaN)
        {
            this.name = name;
            _channels = channels;
            _scene = scene;
            _start = start;
            var last:Number = start;
            for each (var channel:AnimationChannel in channels)
            {
                last = Math.max(last, channel.sampler.end);
            }
            duration = (isNaN(end) ? last : end) - start;
        }

        /** The vertices of the file's model at a time in seconds, as <code>ModelAnimations.verticesAt()</code> gives them. */
        public function verticesAt(time:Number):Vector.<Number>
        {
            var pose:Object = {};
            for each (var channel:AnimationChannel in _channels)
            {
                channel.applyTo(pose, _start + Math.max(0, Math.min(time, duration)));
            }
            var posed:ModelData = new ModelData(_scene.data.name);
            _scene.setPose(pose);
            finish(_scene.adding(posed));
            finish(AffineTransform.toZUp(_scene.data.upAxis).transformingPoints(posed.vertices));
            return posed.vertices;
        }
    }
}
