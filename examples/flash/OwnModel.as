package
{
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.debug.CollisionLines;
    import starlogo.models.Model;

    /** A model of your own: Two spirals of triangles. The collider tests the boxes, one level more every two seconds. Red means that they touch. */
    [SWF(width="600", height="400", frameRate="60", backgroundColor="#eef1ee")]
    public class OwnModel extends Land
    {
        private var _greatLand:GreatLand = new GreatLand();
        private var _collider:HierarchicalCollider = new HierarchicalCollider(_greatLand);
        private var _exact:HierarchicalCollider = new HierarchicalCollider(_greatLand);
        private var _lines:CollisionLines = new CollisionLines(_greatLand);
        private var _still:Agent = make("spiral", "spirals", 9, GREY);
        private var _yours:Agent = make("spiral", "spirals", 6, BLUE);

        public function OwnModel()
        {
            _greatLand.addModel(spiral());
            _exact.exact = true;
            _still.jumpTo(-2, 0, 0);
        }

        /** A band of triangles, whose corners are on two spirals. */
        private function spiral():Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < 60; i++)
            {
                var angle:Number = i / 6;
                vertices.push(i * Math.cos(angle), i * Math.sin(angle), 0);
                vertices.push((i + 9) * Math.cos(angle), (i + 9) * Math.sin(angle), 3);
                if (i > 0)
                {
                    triangles.push(2 * i - 2, 2 * i - 1, 2 * i, 2 * i - 1, 2 * i + 1, 2 * i);
                }
            }
            return new Model("spiral", vertices, triangles);
        }

        override protected function step():void
        {
            _collider.maxDepth = 1 + frame / 120 % 8;
            follow(_yours, 0.06);
            _still.heading += 0.5;
            var isTouch:Boolean = _collider.areColliding(_yours, _still);
            for each (var agent:Agent in new <Agent>[_still, _yours])
            {
                drawLines(_lines.linesOf(agent, _exact), isTouch ? RED : agent.color);
                drawLines(_lines.linesOf(agent, _collider), 0x5a6672);
            }
            var isExact:Boolean = _exact.areColliding(_yours, _still);
            say("boxes of level " + _collider.maxDepth + (isTouch ? " touch" : " do not") + ", triangles " + (isExact ? "touch" : "do not"));
        }
    }
}
