package benchmark
{
    import evaluation.Table;
    import flash.utils.getTimer;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.Contact;
    import starlogo.models.ObjModel;
    import starlogo.terrain.Terrain;
    import support.EachCollider;
    import support.Fixtures;

    /** Frames of twelve bears that walk over hills, sink into them, and are lifted out by the handler of docs/terrain.md; and the same without contacts. */
    public class GroundContactsBenchmark
    {
        public static const FIXTURES:Array = ["/assets/bear.obj"];

        private static const BEARS:int = 12;
        private static const FRAMES:int = 100;

        private var _greatLand:GreatLand = new GreatLand();
        private var _terrain:Terrain = new Terrain(101, 101, 1, -50, -50);

        /** The table. */
        public function run():String
        {
            _greatLand.prepareExact = true;
            _greatLand.addModel(new ObjModel("bear", Fixtures.text(FIXTURES[0])));
            _terrain.raiseMound(0, 0, 20, 3);
            for (var i:int = 0; i < 200; i++)
            {
                _terrain.raiseMound(Math.sin(7 * i) * 40, Math.cos(3 * i) * 40, 8, Math.sin(i) * 1.5);
            }
            var table:Table = new Table("twelve bears", "only called, ms", "with contacts, ms");
            for each (var name:String in EachCollider.NAMES)
            {
                table.add(name, frames(name, false), frames(name, true));
            }
            return table.toString();
        }

        // The time of a frame, in ms. The bears go in circles, and sink a tenth of a patch in each frame.
        private function frames(name:String, hasContacts:Boolean):String
        {
            var collision:Collision = new Collision(EachCollider.make(name, _greatLand) as CollisionSystem);
            var bears:Vector.<Agent> = new Vector.<Agent>();
            collision.terrain = _terrain;
            collision.onCollision("bears", Collision.TERRAIN, hasContacts ? function(bear : Agent, ground:Agent, contact:Contact):void
                {
                    bear.moveTo(bear.x + contact.depth * contact.normal.x, bear.y + contact.depth * contact.normal.y, bear.z + contact.depth * contact.normal.z);
                }
                : function(bear:Agent, ground:Agent):void
                {
                    bear.z += 0.1;
                });
            for (var i:int = 0; i < BEARS; i++)
            {
                var bear:Agent = new Agent("bear", "bears");
                bear.hierarchical = true;
                bear.moveTo(15 * Math.cos(i), 15 * Math.sin(i), _terrain.heightAt(15 * Math.cos(i), 15 * Math.sin(i)));
                bears.push(bear);
            }
            var start:int = 0;
            for (var frame:int = -FRAMES / 2; frame < FRAMES; frame++)
            {
                if (frame == 0)
                {
                    start = getTimer();
                }
                for (i = 0; i < BEARS; i++)
                {
                    bear = bears[i];
                    bear.heading = 30 * i + frame;
                    bear.moveTo(bear.x + 0.05 * Math.cos(i + frame / 50), bear.y + 0.05 * Math.sin(i + frame / 50), bear.z - 0.1);
                }
                collision.update(bears);
            }
            return ((getTimer() - start) / FRAMES).toFixed(2);
        }
    }
}
