// Before another design takes the place of one that is not saved.

import { project } from '../../core/store';
import { leave, leaving } from '../files';
import { Button } from '../parts/button';
import { Modal } from '../parts/modal';

export function LeaveDialog() {
  const stay = () => (leaving.value = null);
  return (
    <Modal
      title={`Save ${project.value?.file || project.value?.name || 'this design'} first?`}
      onClose={stay}
      actions={
        <>
          <Button onClick={stay}>Stay here</Button>
          <Button onClick={() => void leave('drop')}>Go on without saving</Button>
          <Button class="primary" icon="save" onClick={() => void leave('save')}>
            Save and go on
          </Button>
        </>
      }
    >
      <p>What was changed since it was last saved would be lost.</p>
    </Modal>
  );
}
